!!ARBfp1.0
#@ texture 0 = picture across, linear, edge
# Nine texels of a column by five samples: between two texels the filter weighs for us.
PARAM step = { 0.0027027, 0.0063109, 0.0, 0.0 };
PARAM weight = { 0.2270270, 0.3162162, 0.0702703, 1.0 };
ATTRIB here = fragment.texcoord[0];
TEMP at, colour, sum;
TEX colour, here, texture[0], 2D;
MUL sum, colour, weight.x;
ADD at, here, step.zxzz;
TEX colour, at, texture[0], 2D;
MAD sum, colour, weight.y, sum;
SUB at, here, step.zxzz;
TEX colour, at, texture[0], 2D;
MAD sum, colour, weight.y, sum;
ADD at, here, step.zyzz;
TEX colour, at, texture[0], 2D;
MAD sum, colour, weight.z, sum;
SUB at, here, step.zyzz;
TEX colour, at, texture[0], 2D;
MAD result.color, colour, weight.z, sum;
END
