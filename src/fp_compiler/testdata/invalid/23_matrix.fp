!!ARBfp1.0
PARAM a = state.matrix.texture[8].row[0];
PARAM b = state.matrix.modelview[1].row[0];
PARAM c = state.matrix.palette[0].row[0];
PARAM d[] = { state.matrix.program[8] };
END
