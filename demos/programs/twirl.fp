!!ARBfp1.0
# One texture says where in the other one to look.
PARAM amount = program.local[0];    # scale, bias: from [0,1] to texture coordinates
TEMP offset;
TEX offset, fragment.texcoord[0], texture[1], 2D;
MAD offset, offset, amount.x, amount.y;
ADD offset, offset, fragment.texcoord[0];
TEX result.color, offset, texture[0], 2D;
END
