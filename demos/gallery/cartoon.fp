!!ARBfp1.0
#@ title "Cartoon", size 512 512, clear 0.6 0.78 0.85 1
#@ mesh knot tube 0.24, camera orbit yaw -30 pitch 15 distance 3, vertex surface.vp
#@ local[0].xyz "light" = 2 2 3 in -5..5
#@ local[1] = eye
#@ local[2].rgb "paint" = 0.95 0.35 0.2 color
#@ texture 0 = gradient 256 1 low 0.35 high 1 steps 3, nearest, edge
#@ texture 1 = gradient 256 1 low 0.05 high 1 power 0.35 steps 2, linear, edge
# A function is a texture: the first one makes a few paints of the angle to the light, the second one
# inks where the surface turns away from the eye.
PARAM light = program.local[0];
PARAM eye = program.local[1];
PARAM paint = program.local[2];
PARAM half = { 0.5, 0.5, 0.0, 1.0 };
TEMP normal, toLight, toEye, shade, edge;
DP3 normal.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ normal.w, normal.w;
MUL normal.xyz, fragment.texcoord[1], normal.w;
SUB toLight, light, fragment.texcoord[2];
DP3 toLight.w, toLight, toLight;
RSQ toLight.w, toLight.w;
MUL toLight.xyz, toLight, toLight.w;
SUB toEye, eye, fragment.texcoord[2];
DP3 toEye.w, toEye, toEye;
RSQ toEye.w, toEye.w;
MUL toEye.xyz, toEye, toEye.w;
DP3 shade.x, normal, toLight;
MAD shade.x, shade.x, half.x, half.y;
DP3_SAT edge.x, normal, toEye;
TEX shade, shade.x, texture[0], 1D;
TEX edge, edge.x, texture[1], 1D;
MUL shade, shade, edge;
MUL result.color.xyz, shade, paint;
MOV result.color.w, half.w;
END
