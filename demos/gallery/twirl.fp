!!ARBfp1.0
#@ title "Displacement: twirl", profile r300, size 512 512, mesh quad, camera none, blend off
#@ local[0].x "magnitude" = 1 in -1..1 animate sine 5s
#@ texture 0 = landscape 512 512, linear, edge
#@ texture 1 = twirl 512 512 radius 0.47 turn 4.5, nearest, edge
# One texture says where in the other one to look.
PARAM magnitude = program.local[0];
PARAM zero = { 0.5000076, 0.5000076, 0.0, 0.0 };
TEMP offset;
TEX offset, fragment.texcoord[0], texture[1], 2D;
SUB offset, offset, zero;
MAD offset, offset, magnitude.x, fragment.texcoord[0];
TEX result.color, offset, texture[0], 2D;
END
