!!ARBfp1.0
TEMP colour;
mov colour, fragment.colour;
MAD colour, colour, colour, color;
TEX colour, fragment.texcoord[0], texture[0], CUBEMAP;
MOV result.color, state.matrix.modelview.inverted.row[0];
MOV result.color, state.material.front.difuse;
END
