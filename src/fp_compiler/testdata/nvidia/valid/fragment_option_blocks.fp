!!ARBfp1.0
OPTION NV_fragment_program2;
# An IF without jumps is a choice between what both of its parts make; a count that is not known is
# a loop.
TEMP a, b, n;
PARAM turns = program.local[0];
MOV a, fragment.color;
REP turns.x;
  MADC b, a, fragment.texcoord[0], -0.5;
  BRK (GT.w);
  IF LT.x;
    ADDC a.xy, a, b;
    IF GE.y;
      MOV n.z, a.x;
    ENDIF;
    KIL LT.y;
  ELSE;
    MUL_SAT a, a, b;
    MOV n, 0.25;
  ENDIF;
ENDREP;
MAD result.color, a, 0.5, n;
END
