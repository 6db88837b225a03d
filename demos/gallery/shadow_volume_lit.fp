!!ARBfp1.0
#@ keep, depth equal write off, stencil lit, blend add
#@ mesh torus parts 32 at 0 0.3 0 scale 0.8 and plane at 0 -0.6 0 scale 2
#@ vertex surface.vp
#@ local[0].xyz "light" = 2 4 1.5
PARAM light = program.local[0];
PARAM levels = { 0.7, 0.65, 0.5, 0.0 };
TEMP normal, toLight;
DP3 normal.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ normal.w, normal.w;
MUL normal.xyz, fragment.texcoord[1], normal.w;
SUB toLight, light, fragment.texcoord[2];
DP3 toLight.w, toLight, toLight;
RSQ toLight.w, toLight.w;
MUL toLight.xyz, toLight, toLight.w;
DP3_SAT normal.x, normal, toLight;
MUL result.color, levels, normal.x;
END
