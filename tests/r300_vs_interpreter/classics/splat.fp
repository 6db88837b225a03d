!!ARBfp1.0
# Terrain: three ground textures by the weights of a fourth.
TEMP weights, grass, rock, sand;
TEX weights, fragment.texcoord[0], texture[0], 2D;
TEX grass, fragment.texcoord[1], texture[1], 2D;
TEX rock, fragment.texcoord[1], texture[2], 2D;
TEX sand, fragment.texcoord[1], texture[3], 2D;
LRP rock, weights.x, grass, rock;
LRP rock, weights.y, sand, rock;
MUL result.color, rock, fragment.color;
END
