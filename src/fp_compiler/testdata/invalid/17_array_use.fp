!!ARBfp1.0
PARAM p[] = { 1, 2 };
PARAM q = 1;
TEMP t;
MOV t, p;
MOV t, q[0];
ADD t, p.x, t[0];
END
