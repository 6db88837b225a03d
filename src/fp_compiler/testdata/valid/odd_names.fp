!!ARBfp1.0
TEMP out, half, input, default, const, reflect, exp, step, __tmp_texcoord0, gl_Color, $1;
MOV out, fragment.color;
MOV $1, out;
MOV result.color, $1;
END
