!!ARBfp1.0
TEMP normal;
MOV result.color, noraml;
MOV nothing, normal;
END
