!!FP1.0
# Constants by name, parameters that the application sets by name, and by number.
DEFINE half = {0.5, 0.5, 0.5, 0.5};
DECLARE tint = {1, 0.5, 0.25, 1};
DECLARE offset;
TEX R0, f[TEX0], TEX0, 2D;
MULH H1, R0, tint;
ADDH H1, H1, p[3];
ADDX_SAT H2.xyz, H1, offset;
MULR R3, H2, half.x;
MOVH o[COLH], R3;
END
