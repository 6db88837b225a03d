!!ARBfp1.0
TEMP t;
MOV t.yx, t;
MOV t.xg, t;
MOV t, t.xyzr;
MOV t, t.xy;
RCP t, t;
RCP t, t.xy;
END
