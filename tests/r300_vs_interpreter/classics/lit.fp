!!ARBfp1.0
# Blinn's lighting: normal, light and halfway vectors made unit length for each pixel.
TEMP n, l, h, d, base;
TEX base, fragment.texcoord[0], texture[0], 2D;
DP3 n.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ n.w, n.w;
MUL n.xyz, fragment.texcoord[1], n.w;
DP3 l.w, fragment.texcoord[2], fragment.texcoord[2];
RSQ l.w, l.w;
MUL l.xyz, fragment.texcoord[2], l.w;
DP3 h.w, fragment.texcoord[3], fragment.texcoord[3];
RSQ h.w, h.w;
MUL h.xyz, fragment.texcoord[3], h.w;
DP3 d.x, n, l;
DP3 d.y, n, h;
MOV d.w, program.local[0].w;
LIT d, d;
MUL base.xyz, base, d.y;
MAD result.color.xyz, program.local[1], d.z, base;
MOV result.color.w, base.w;
END
