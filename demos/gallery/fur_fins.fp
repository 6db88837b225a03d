!!ARBfp1.0
#@ keep
#@ mesh fins parts 5 of sphere parts 48 scale 0.8
#@ vertex fur_fins.vp, texcoord 1 = extra
#@ texture 0 = hairs 256 256 density 0.35, nearest
# Seen from the side, shells have gaps; a fin is fur cut along an edge of the surface. Its hairs are
# those of the shells, shorter where the surface faces the eye, and none where it does so by half.
PARAM levels = { 0.35, 0.65, 1.5, 1.0 };
PARAM facing = { -3.0, 0.0, 0.0, 0.0 };
TEMP hair, left;
TEX hair, fragment.texcoord[0], texture[0], 2D;
MAD_SAT left.y, fragment.texcoord[1].z, facing.x, levels.z;
MUL left.x, hair.w, left.y;
SUB left, left.x, fragment.texcoord[1].x;
KIL left;
MAD left.x, fragment.texcoord[1].x, levels.y, levels.x;
MUL left.x, left.x, fragment.texcoord[1].y;
MUL result.color.xyz, hair, left.x;
MOV result.color.w, levels.w;
END
