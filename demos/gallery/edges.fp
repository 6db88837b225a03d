!!ARBfp1.0
#@ title "Filter: edges", size 512 512
#@ texture 0 = landscape 512 512, linear, edge
#@ local[0].x "strength" = 1 in 0..8
# Sobel's operator on brightness: the differences across and up, then their length. All places are
# computed before the first sample: a sample of a place that another one came before costs a node.
PARAM strength = program.local[0];
PARAM step = { 0.001953125, 0.001953125, -0.001953125, 0.0 };
PARAM grey = { 0.299, 0.587, 0.114, 0.0 };
PARAM two = { 2.0, 0.00001, 0.0, 1.0 };
ATTRIB here = fragment.texcoord[0];
TEMP n, ne, e, se, s, sw, w, nw, slope;
ADD n, here, step.wyww;
ADD ne, here, step.xyww;
ADD e, here, step.xwww;
SUB se, here, step.zyww;
SUB s, here, step.wyww;
SUB sw, here, step.xyww;
ADD w, here, step.zwww;
ADD nw, here, step.zyww;
TEX n, n, texture[0], 2D;
TEX ne, ne, texture[0], 2D;
TEX e, e, texture[0], 2D;
TEX se, se, texture[0], 2D;
TEX s, s, texture[0], 2D;
TEX sw, sw, texture[0], 2D;
TEX w, w, texture[0], 2D;
TEX nw, nw, texture[0], 2D;
# Right column minus left one; upper row minus lower one.
SUB e, e, w;
SUB n, n, s;
SUB ne, ne, sw;
SUB nw, nw, se;
MAD e, e, two.x, ne;
SUB e, e, nw;
MAD n, n, two.x, ne;
ADD n, n, nw;
DP3 slope.x, e, grey;
DP3 slope.y, n, grey;
MUL slope.xy, slope, slope;
ADD slope.x, slope.x, slope.y;
ADD slope.x, slope.x, two.y;
RSQ slope.y, slope.x;
MUL slope.x, slope.x, slope.y;
MUL_SAT result.color.xyz, slope.x, strength.x;
MOV result.color.w, two.w;
END
