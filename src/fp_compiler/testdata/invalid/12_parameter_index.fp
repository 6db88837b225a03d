!!ARBfp1.0
PARAM p = program.env[32];
PARAM q = program.local[4294967296];
END
