!!ARBfp1.0
TEMP offset, at;
TEX offset, fragment.texcoord[0], texture[1], 2D;
MAD at, offset, program.local[0], fragment.texcoord[0];
TEX result.color, at, texture[0], 2D;
END
