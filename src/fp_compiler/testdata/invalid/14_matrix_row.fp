!!ARBfp1.0
PARAM p = state.matrix.mvp.row[4];
PARAM q[] = { state.matrix.mvp.row[3..1] };
PARAM r = state.matrix.mvp;
END
