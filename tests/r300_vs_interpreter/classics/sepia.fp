!!ARBfp1.0
# Towards one tint, by a share.
TEMP colour, grey;
PARAM luminance = {0.299, 0.587, 0.114, 0.0};
TEX colour, fragment.texcoord[0], texture[0], 2D;
DP3 grey.xyz, colour, luminance;
MUL grey.xyz, grey, program.local[0];
LRP result.color.xyz, program.local[1].x, grey, colour;
MOV result.color.w, colour.w;
END
