!!ARBfp1.0
TEMP a;
MOV a, fragment.color;
PARAM p[] = { program.local[0..3] };
TEMP b;
ALIAS q = p;
MUL b, a, q[3];
OUTPUT o = result.color;
MOV o, b;
END
