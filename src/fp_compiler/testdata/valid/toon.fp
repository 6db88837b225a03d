!!ARBfp1.0
TEMP n, l;
DP3 n.w, fragment.texcoord[0], fragment.texcoord[0];
RSQ n.w, n.w;
MUL n.xyz, fragment.texcoord[0], n.w;
DP3 l.x, n, state.light[0].half;
MAX l.x, l.x, 0;
TEX l, l.x, texture[0], 1D;
MUL result.color, l, state.material.diffuse;
END
