!!ARBfp1.0
# The picture as it is.
TEX result.color, fragment.texcoord[0], texture[0], 2D;
END
