!!ARBfp1.0
#@ camera orbit yaw -30 pitch 30 distance 5 fov 40, vertex shadow_map_scene.vp
#@ clear 0.5 0.6 0.7 1
#@ texture 0 = depthof shadow, nearest, edge
#@ local[0].x "bias" = 0.004 in 0..0.02
# A place is in shadow if the light saw something nearer in its direction.
PARAM bias = program.local[0];
PARAM levels = { 0.3, 0.7, 0.5, 1.0 };
TEMP place, seen, shade;
RCP place.w, fragment.texcoord[3].w;
MUL place.xyz, fragment.texcoord[3], place.w;
TEX seen, place, texture[0], 2D;
ADD seen.x, seen.x, bias.x;
SGE seen.x, seen.x, place.z;
DP3 shade.w, fragment.texcoord[2], fragment.texcoord[2];
RSQ shade.w, shade.w;
MUL shade.xyz, fragment.texcoord[2], shade.w;
DP3_SAT shade.x, fragment.texcoord[1], shade;
MUL shade.x, shade.x, seen.x;
MAD result.color.xyz, shade.x, levels.y, levels.x;
MOV result.color.w, levels.w;
END
