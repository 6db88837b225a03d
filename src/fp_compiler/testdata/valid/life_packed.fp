!!ARBfp1.0
# Neighbours packed into the channels of one sample and a small table.
PARAM step = program.local[0];
TEMP above, here, below, sum, at;
ADD at, fragment.texcoord[0], step.zyww;
TEX here, fragment.texcoord[0], texture[0], 2D;
TEX above, fragment.texcoord[1], texture[0], 2D;
TEX below, fragment.texcoord[2], texture[0], 2D;
ADD sum, above, below;
ADD sum, sum, here;
DP3 sum.x, sum, { 0.1, 0.1, 0.1 };
MOV sum.y, here.g;
TEX result.color, sum, texture[1], 2D;
END
