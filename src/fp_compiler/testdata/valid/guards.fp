!!ARBfp1.0
# Where a zero base or exponent can occur and where it cannot.
TEMP a, b;
PARAM e = 2.5;
MOV_SAT a, fragment.texcoord[0];
POW b.x, a.x, e.x;
POW b.y, fragment.texcoord[0].y, e.x;
POW b.z, a.z, program.local[0].x;
MAX a, fragment.texcoord[1], 0.0;
POW b.w, a.w, fragment.texcoord[1].x;
LIT a, b;
SGE b, a, b;
MUL b.y, b, a;
MOV a.w, program.local[1].x;
LIT a.yz, a.xyzw;
DST b.xw, a, b;
SCS a.xy, a.x;
XPD b.xyz, a, b;
ADD result.color, a, b;
END
