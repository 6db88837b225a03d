!!ARBfp1.0
# The height moves the coordinates towards the eye before the surface is looked up.
TEMP place, colour, normal;
TEX place, fragment.texcoord[0], texture[0], 2D;
MAD place.xy, place.x, program.local[0].x, program.local[0].y;
MAD place.xy, place, fragment.texcoord[1], fragment.texcoord[0];
TEX colour, place, texture[1], 2D;
TEX normal, place, texture[2], 2D;
DP3_SAT normal, normal, fragment.texcoord[2];
MUL result.color, colour, normal;
END
