!!ARBfp1.0
PARAM a[0] = { 1 };
PARAM b[33] = { 1 };
PARAM c[2] = { 1, 2, 3 };
PARAM d[3] = { 1, 2 };
END
