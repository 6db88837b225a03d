!!ARBfp1.0
OPTION ARB_fog_linear;
# What fixed function does: texture times colour, then fog.
TEMP texel;
TEX texel, fragment.texcoord[0], texture[0], 2D;
MUL result.color, texel, fragment.color;
END
