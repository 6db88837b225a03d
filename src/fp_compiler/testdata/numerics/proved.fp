!!ARBfp1.0
# Products of what is known to be finite, and one factor at a time that is not.
TEMP t, u;
ATTRIB c = fragment.color;
MUL t, c, {0.0, 1.0, 0.5, 2.0};
MAD_SAT u, fragment.texcoord[1], 2.0, t;
LRP t, u, c, fragment.color.secondary;
DP3 t.w, t, u;
MUL u.xyz, t, fragment.texcoord[2];
MUL u.w, t.w, fragment.texcoord[2].w;
MAD result.color, u, 0.25, t;
END
