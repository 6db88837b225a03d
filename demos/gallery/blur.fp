!!ARBfp1.0
#@ title "Filter: blur in two passes", size 512 512
#@ texture 0 = landscape 512 512, linear, edge
#@ target across 512 512, then blur_down.fp
# Nine texels of a row by five samples: between two texels the filter weighs for us.
PARAM step = { 0.0027027, 0.0063109, 0.0, 0.0 };
PARAM weight = { 0.2270270, 0.3162162, 0.0702703, 1.0 };
ATTRIB here = fragment.texcoord[0];
TEMP far, near, middle, back, farther, sum;
ADD near, here, step.xzzz;
SUB back, here, step.xzzz;
ADD far, here, step.yzzz;
SUB farther, here, step.yzzz;
TEX middle, here, texture[0], 2D;
TEX near, near, texture[0], 2D;
TEX back, back, texture[0], 2D;
TEX far, far, texture[0], 2D;
TEX farther, farther, texture[0], 2D;
ADD near, near, back;
ADD far, far, farther;
MUL sum, middle, weight.x;
MAD sum, near, weight.y, sum;
MAD result.color, far, weight.z, sum;
END
