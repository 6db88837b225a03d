!!ARBfp1.0
# Leaves: what is not opaque enough is not there.
TEMP colour, left;
TEX colour, fragment.texcoord[0], texture[0], 2D;
SUB left, colour.w, program.local[0].x;
KIL left;
MUL result.color, colour, fragment.color;
END
