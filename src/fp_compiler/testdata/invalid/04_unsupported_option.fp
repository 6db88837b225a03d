!!ARBfp1.0
OPTION NV_fragment_program;
OPTION ARB_fog_ex;
OPTION ARB_position_invariant;
END
