!!ARBfp1.0
MOV result.color, state.light[8].ambient;
MOV result.color, state.lightprod[9].ambient;
END
