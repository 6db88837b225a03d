!!ARBfp1.0
#@ title "Filter: edges", size 512 512
#@ texture 0 = landscape 512 512, linear, edge
#@ local[0].x "strength" = 2 in 0..8
# Sobel's operator on brightness: the differences across and up, then their length.
PARAM strength = program.local[0];
PARAM step = { 0.001953125, 0.001953125, -0.001953125, 0.0 };
PARAM grey = { 0.299, 0.587, 0.114, 2.0 };
PARAM two = { 2.0, 1.0, 0.0, 0.0 };
ATTRIB here = fragment.texcoord[0];
TEMP at, colour, row, slope;
ADD at, here, step.xyww;
TEX colour, at, texture[0], 2D;
DP3 row.x, colour, grey;
ADD at, here, step.xwww;
TEX colour, at, texture[0], 2D;
DP3 row.y, colour, grey;
SUB at, here, step.zyww;
TEX colour, at, texture[0], 2D;
DP3 row.z, colour, grey;
ADD at, here, step.zyww;
TEX colour, at, texture[0], 2D;
DP3 row.w, colour, grey;
# Right column minus left one; upper row minus lower one.
MAD slope.x, row.y, two.x, row.x;
ADD slope.x, slope.x, row.z;
SUB slope.x, slope.x, row.w;
ADD slope.y, row.x, row.w;
SUB slope.y, slope.y, row.z;
ADD at, here, step.zwww;
TEX colour, at, texture[0], 2D;
DP3 row.x, colour, grey;
MAD slope.x, row.x, -two.x, slope.x;
SUB at, here, step.xyww;
TEX colour, at, texture[0], 2D;
DP3 row.y, colour, grey;
SUB slope.x, slope.x, row.y;
SUB slope.y, slope.y, row.y;
ADD at, here, step.wyww;
TEX colour, at, texture[0], 2D;
DP3 row.z, colour, grey;
MAD slope.y, row.z, two.x, slope.y;
SUB at, here, step.wyww;
TEX colour, at, texture[0], 2D;
DP3 row.w, colour, grey;
MAD slope.y, row.w, -two.x, slope.y;
MUL slope.xy, slope, slope;
ADD slope.x, slope.x, slope.y;
ADD slope.x, slope.x, two.z;
RSQ slope.y, slope.x;
MUL slope.x, slope.x, slope.y;
MUL_SAT result.color, slope.x, strength.x;
END
