!!ARBfp1.0
TEMP a, MOV, texture;
PARAM END = 1;
END
