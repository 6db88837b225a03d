!!ARBfp1.0
TEMP a, b;
MOV a b;
ADD a, b;
MOV a, b
MOV b, a;
;
MOV a, |b|;
END
