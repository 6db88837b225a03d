!!ARBfp1.0
PARAM m = state.material.ambient;
PARAM n = state.material.back.shininess;
PARAM l[] = { state.light[0].position, state.light[1].spot.direction, state.light[2].half,
              state.light[3].attenuation };
PARAM s = state.lightmodel.back.scenecolor;
PARAM e = state.texenv[1].color;
PARAM d = state.depth.range;
PARAM x[4] = { state.matrix.modelview.invtrans };
PARAM y[] = { state.matrix.program[3].row[1..2], state.matrix.texture[1].transpose.row[0] };
TEMP t;
MAD t, m, n.x, l[0];
MAD t, l[1], l[2], t;
MAD t, l[3], s, t;
MAD t, e, d.z, t;
DP4 t.x, x[0], t;
DP4 t.y, x[3], t;
DP4 t.z, y[1], t;
DP4 t.w, y[2], t;
MUL t, t, state.fog.color;
MAD result.color, t, state.fog.params.w, state.matrix.mvp.inverse.row[3];
END
