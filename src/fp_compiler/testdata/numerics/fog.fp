!!ARBfp1.0
OPTION ARB_fog_exp2;
MUL result.color, fragment.color, state.material.diffuse;
END
