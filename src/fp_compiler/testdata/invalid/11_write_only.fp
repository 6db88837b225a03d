!!ARBfp1.0
OUTPUT o = result.color;
TEMP t;
ADD t, o, result.depth;
END
