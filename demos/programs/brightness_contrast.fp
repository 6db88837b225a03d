!!ARBfp1.0
# Brightness bends the middle tones by a power; contrast stretches about middle grey.
PARAM level = program.local[0];    # exponent, contrast, offset
TEMP colour;
TEX colour, fragment.texcoord[0], texture[0], 2D;
POW colour.x, colour.x, level.x;
POW colour.y, colour.y, level.x;
POW colour.z, colour.z, level.x;
MAD result.color, colour, level.y, level.z;
END
