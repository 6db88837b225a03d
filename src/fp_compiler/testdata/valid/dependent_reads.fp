!!ARBfp1.0
TEMP a, b;
TEX a, fragment.texcoord[0], texture[0], 2D;
TEX b, a, texture[1], 2D;
MUL b, b, a;
TEX a, b, texture[2], 2D;
MOV result.color, a;
END
