!!ARBfp1.0
SHORT TEMP h;
TEMP t;
DDX t, t;
ADDR t, t, t;
MULH_SAT t, t, t;
MOVC t, t;
TXD t, t, t, t, texture[0], 2D;
END
