!!ARBfp1.0
#@ title "Filter: blur in two passes", size 512 512
#@ texture 0 = landscape 512 512, linear, edge
#@ target across 512 512, then blur_down.fp
# Nine texels of a row by five samples: between two texels the filter weighs for us.
PARAM step = { 0.0027027, 0.0063109, 0.0, 0.0 };
PARAM weight = { 0.2270270, 0.3162162, 0.0702703, 1.0 };
ATTRIB here = fragment.texcoord[0];
TEMP at, colour, sum;
TEX colour, here, texture[0], 2D;
MUL sum, colour, weight.x;
ADD at, here, step.xzzz;
TEX colour, at, texture[0], 2D;
MAD sum, colour, weight.y, sum;
SUB at, here, step.xzzz;
TEX colour, at, texture[0], 2D;
MAD sum, colour, weight.y, sum;
ADD at, here, step.yzzz;
TEX colour, at, texture[0], 2D;
MAD sum, colour, weight.z, sum;
SUB at, here, step.yzzz;
TEX colour, at, texture[0], 2D;
MAD result.color, colour, weight.z, sum;
END
