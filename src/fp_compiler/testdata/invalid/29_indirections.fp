!!ARBfp1.0
TEMP t;
ADD t, t, 1;
TEX t, t, texture[0], 2D;
ADD t, t, 1;
TEX t, t, texture[0], 2D;
ADD t, t, 1;
TEX t, t, texture[0], 2D;
ADD t, t, 1;
TEX t, t, texture[0], 2D;
MOV result.color, t;
END
