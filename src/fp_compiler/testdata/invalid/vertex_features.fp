!!ARBfp1.0
ADDRESS A0;
PARAM p[] = { 1, 2 };
ARL A0.x, p[0].x;
TEMP t;
MOV t, p[A0.x + 1];
MOV result.position, vertex.position;
LOG t, t.x;
PARAM c = state.clip[0].plane;
END
