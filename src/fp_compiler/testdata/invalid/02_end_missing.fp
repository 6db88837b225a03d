!!ARBfp1.0
TEMP a;
MOV a, 1;
# END
