!!ARBfp1.0
PARAM a = { .5, 5., 1e3, 1.5E-2 };
PARAM b = -2;
PARAM c = { +1, 007, 1e-40, 1e999 };
MAD result.color, a, b, c;
END
