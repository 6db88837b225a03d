!!ARBfp1.0
PARAM p[] = { 1, 2, 3 };
TEMP t;
MOV t, p[3];
MOV t, p[t.x];
MOV t, p[-1];
END
