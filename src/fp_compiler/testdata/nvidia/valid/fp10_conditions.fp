!!FP1.0
# Condition codes under masks and tests, KIL by a test, packing.
MOVC RC, f[COL0];
MOVR R1 (LT.x), -f[COL0];
ADDRC R1.xy (GE.yxzw), R1, f[TEX1];
SGTH H4, |R1|, {0.5};
KIL NE.w;
PK4UB R2.x, R1;
UP4UB R5, R2.x;
LRPX o[COLR], H4, R5, R1;
MOVR o[DEPR].z, f[WPOS].z;
END
