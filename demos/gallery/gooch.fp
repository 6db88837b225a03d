!!ARBfp1.0
#@ title "Gooch shading", size 512 512, clear 0.95 0.94 0.9 1
#@ mesh knot, camera orbit yaw 20 pitch 25 distance 3, vertex surface.vp
#@ local[0].xyz "light" = 2 3 2 in -5..5 animate turn 8s
#@ local[1].rgb "cool" = 0.15 0.25 0.6 color
#@ local[2].rgb "warm" = 0.85 0.65 0.2 color
#@ local[3] = eye
# From cool to warm by the angle to the light, as technical drawings are shaded; a highlight is added.
PARAM light = program.local[0];
PARAM cool = program.local[1];
PARAM warm = program.local[2];
PARAM eye = program.local[3];
PARAM half = { 0.5, 0.5, 32.0, 1.0 };
TEMP normal, toLight, toEye, shade, colour;
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
MAD toEye.xyz, toEye, toEye.w, toLight;
DP3 toEye.w, toEye, toEye;
RSQ toEye.w, toEye.w;
MUL toEye.xyz, toEye, toEye.w;
DP3 shade.x, normal, toLight;
MAD shade.x, shade.x, half.x, half.y;
LRP colour.xyz, shade.x, warm, cool;
DP3_SAT shade.y, normal, toEye;
POW shade.y, shade.y, half.z;
ADD_SAT result.color.xyz, colour, shade.y;
MOV result.color.w, half.w;
END
