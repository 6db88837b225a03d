!!ARBfp1.0
# Every product, of factors of which nothing is known.
TEMP t, u;
PARAM p = program.local[0];
ATTRIB c = fragment.texcoord[0];
TEX t, c, texture[0], 2D;
MUL u, t, p;
MAD t, u, c, t;
DP3 u.x, t, p;
DP4 u.y, t, p;
DPH u.z, t, p;
LRP t, p, u, c;
XPD u.xyz, t, p;
DST t, u, p;
POW u.w, t.x, p.y;
LIT t.xyz, u;
RCP t.w, u.x;
MUL result.color, t, u;
END
