!!ARBfp1.0
# local[0]: brightness, contrast, gamma
PARAM control = program.local[0];
PARAM half = { 0.5, 0.5, 0.5, 0.5 };
TEMP colour, scaled;
TEX colour, fragment.texcoord[0], texture[0], 2D;
SUB scaled, colour, half;
MAD scaled, scaled, control.y, half;
ADD_SAT scaled, scaled, control.x;
POW colour.r, scaled.r, control.z;
POW colour.g, scaled.g, control.z;
POW colour.b, scaled.b, control.z;
MOV result.color, colour;
END
