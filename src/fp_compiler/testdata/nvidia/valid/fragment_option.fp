!!ARBfp1.0
OPTION NV_fragment_program;
SHORT TEMP h;
LONG TEMP r;
TEMP t;
PARAM c[3] = { program.local[0..2] };
SLTC t.x, fragment.color, c[0];
MOVH h (GT.x), c[1];
MADR_SAT r, h, t.x, c[2];
PK2H t.x, r;
UP2H t, t.x;
DDY h, fragment.texcoord[0];
TXD r, fragment.texcoord[0], h, t, texture[0], 2D;
RFL result.color.xyz, r, c[1];
MOV result.color.w, c[0];
KIL LT.w;
END
