!!ARBfp1.0
# A reflection where the base texture's alpha says that the surface is polished.
TEMP base, mirror;
TEX base, fragment.texcoord[0], texture[0], 2D;
TEX mirror, fragment.texcoord[1], texture[1], CUBE;
MUL mirror.xyz, mirror, base.w;
MAD result.color.xyz, base, fragment.color, mirror;
MOV result.color.w, fragment.color.w;
END
