!!ARBfp1.0
TEMP t;
SWZ t, -t, x, y, z, w;
SWZ t, t.xyzw, x, y, z, w;
SWZ t, t, x, y, 2, a;
END
