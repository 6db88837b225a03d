!!ARBfp1.0
TEMP a;
OPTION ARB_fog_exp;
END
