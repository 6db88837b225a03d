!!ARBfp1.0
MOV result.color, fragment.texcoord[8];
END
