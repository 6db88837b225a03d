!!ARBfp1.0
#@ title "Light map", size 512 512
#@ mesh plane scale 1.2, camera orbit yaw 25 pitch 60 distance 3
#@ texcoord 1 = st 0 0
#@ texture 0 = bricks 256 256 rows 8 columns 8, linear
#@ texture 1 = spot 128 128 radius 0.6 ambient 0.15, linear, edge
#@ local[0].x "brightness" = 1.4 in 0..2
# What light is where was computed before, once: its texture times the surface's.
PARAM brightness = program.local[0];
TEMP surface, light;
TEX surface, fragment.texcoord[0], texture[0], 2D;
TEX light, fragment.texcoord[1], texture[1], 2D;
MUL light, light, brightness.x;
MUL_SAT result.color.xyz, surface, light;
MOV result.color.w, surface.w;
END
