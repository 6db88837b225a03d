!!ARBfp1.0
MOV result.color, state.texenv[8].color;
END
