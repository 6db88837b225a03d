!!ARBfp1.0
#@ title "Skinning by a matrix palette", size 512 512, clear 0.2 0.22 0.26 1
#@ mesh cylinder parts 48 radius 0.3, camera orbit yaw 15 pitch 10 distance 3.4
#@ vertex skinning.vp, texcoord 1 = extra
#@ texture 0 = checker 256 256 cells 16 dark 0.5
#@ local[0].xyz "light" = 0.4 0.5 0.75 in -1..1
# The mesh is the same in each frame; the vertex program bends it.
PARAM light = program.local[0];
PARAM levels = { 0.25, 0.75, 0.0, 1.0 };
TEMP surface, normal;
TEX surface, fragment.texcoord[0], texture[0], 2D;
DP3 normal.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ normal.w, normal.w;
MUL normal.xyz, fragment.texcoord[1], normal.w;
DP3_SAT normal.x, normal, light;
MAD normal.x, normal.x, levels.y, levels.x;
MUL result.color.xyz, surface, normal.x;
MOV result.color.w, levels.w;
END
