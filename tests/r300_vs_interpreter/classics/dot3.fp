!!ARBfp1.0
# A normal map and a light vector, both in [0,1].
TEMP normal, light, base;
TEX normal, fragment.texcoord[0], texture[0], 2D;
TEX base, fragment.texcoord[0], texture[1], 2D;
MAD normal.xyz, normal, 2.0, -1.0;
MAD light.xyz, fragment.color, 2.0, -1.0;
DP3_SAT light, normal, light;
MUL result.color, base, light;
END
