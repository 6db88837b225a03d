!!ARBfp1.0
# A projected light that fades with the square of the distance.
TEMP light, base, fall;
TXP light, fragment.texcoord[1], texture[1], 2D;
TEX base, fragment.texcoord[0], texture[0], 2D;
DP3 fall.w, fragment.texcoord[2], fragment.texcoord[2];
RCP fall.w, fall.w;
MUL light.xyz, base, light;
MUL result.color.xyz, light, fall.w;
MOV result.color.w, base.w;
END
