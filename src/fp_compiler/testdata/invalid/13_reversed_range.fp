!!ARBfp1.0
PARAM p[] = { program.env[5..3] };
END
