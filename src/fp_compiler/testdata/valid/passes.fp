!!ARBfp1.0
# What the passes of opt/ are for: copies, constants, identities, repetition, waste.
TEMP copy, half, n, unused, sum, zero;
PARAM one = 1.0;
PARAM table[2] = { { 2.0, 4.0, 8.0, 16.0 }, program.local[0] };
MOV copy, -fragment.texcoord[0].wzyx;
RCP half.x, table[0].x;
MAD n, copy.wzyx, one, table[1];            # ADD
MUL sum, half.x, table[0];                  # constant
ADD sum, sum, n;
ADD unused, sum, n;
MAD sum.xyz, copy.wzyx, one, table[1];      # the same as n
ABS half.y, -sum.x;
CMP zero, table[0], sum, half;              # third operand
POW half.z, sum.x, zero.w;
MUL zero.xy, zero, 0.0;
KIL table[0];                               # never
SWZ result.color, sum, x, 1, -z, 0;
MOV result.color.w, half.y;
END
