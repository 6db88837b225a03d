!!ARBfp1.0
# A normal map taken to the world by three rows, and the reflection that it gives.
TEMP normal, world, mirror;
TEX normal, fragment.texcoord[0], texture[0], 2D;
MAD normal.xyz, normal, 2.0, -1.0;
DP3 world.x, fragment.texcoord[1], normal;
DP3 world.y, fragment.texcoord[2], normal;
DP3 world.z, fragment.texcoord[3], normal;
DP3 world.w, world, fragment.texcoord[4];
ADD world.w, world.w, world.w;
MAD mirror.xyz, world.w, world, -fragment.texcoord[4];
TEX mirror, mirror, texture[1], CUBE;
MUL result.color, mirror, fragment.color;
END
