!!ARBfp1.0
#@ title "Particles on billboards", size 512 512, clear 0.03 0.03 0.06 1
#@ mesh billboards count 96 seed 5, camera orbit pitch 10 distance 4
#@ vertex particles.vp, texcoord 1 = extra, blend add, depth off
#@ texture 0 = spot 64 64 radius 0.5, linear, edge
#@ local[0].rgb "young" = 1 0.75 0.3 color, local[1].rgb "old" = 0.25 0.1 0.5 color
# A spot of light whose colour is the particle's age.
PARAM young = program.local[0];
PARAM old = program.local[1];
TEMP spot, colour;
TEX spot, fragment.texcoord[0], texture[0], 2D;
LRP colour, fragment.texcoord[1].x, old, young;
MUL colour, colour, fragment.texcoord[1].y;
MUL result.color, colour, spot.w;
END
