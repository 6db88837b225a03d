!!ARBfp1.0
# Two waves that pass each other bend the place where the reflection is looked up.
TEMP wave, other, colour;
TEX wave, fragment.texcoord[0], texture[0], 2D;
TEX other, fragment.texcoord[1], texture[0], 2D;
ADD wave.xy, wave, other;
MAD wave.xy, wave, program.local[0].x, fragment.texcoord[2];
TEX colour, wave, texture[1], 2D;
MUL result.color, colour, program.local[1];
END
