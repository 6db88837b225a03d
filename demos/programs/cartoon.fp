!!ARBfp1.0
# Shading by steps: a 1D texture turns the angle to the light into one of a few paints, and a
# second one inks the outline, where the surface turns away from the eye.
PARAM light = program.local[0];            # direction to the light, unit length, eye space
PARAM toUnit = {0.5, 0.5, 0.0, 0.0};
TEMP normal, eye, shade, edge;

DP3 normal.w, fragment.texcoord[0], fragment.texcoord[0];
RSQ normal.w, normal.w;
MUL normal.xyz, fragment.texcoord[0], normal.w;
DP3 eye.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ eye.w, eye.w;
MUL eye.xyz, -fragment.texcoord[1], eye.w;

DP3 shade.x, normal, light;
MAD shade.x, shade.x, toUnit.x, toUnit.y;
DP3_SAT edge.x, normal, eye;
TEX shade, shade, texture[0], 1D;
TEX edge, edge, texture[1], 1D;
MUL result.color, shade, edge;
END
