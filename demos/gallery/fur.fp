!!ARBfp1.0
#@ title "Fur in shells and fins", size 512 512, clear 0.1 0.12 0.16 1
#@ mesh shells count 14 of sphere parts 48 scale 0.8, camera orbit pitch 20 distance 3
#@ vertex fur.vp, texcoord 1 = extra, then fur_fins.fp
#@ texture 0 = hairs 256 256 density 0.35, nearest
# Each shell keeps the hairs that are long enough to reach it; those below lie in their shade.
PARAM levels = { 0.35, 0.65, 0.0, 1.0 };
TEMP hair, left;
TEX hair, fragment.texcoord[0], texture[0], 2D;
SUB left, hair.w, fragment.texcoord[1].x;
KIL left;
MAD left.x, fragment.texcoord[1].x, levels.y, levels.x;
MUL left.x, left.x, fragment.texcoord[1].y;
MUL result.color.xyz, hair, left.x;
MOV result.color.w, levels.w;
END
