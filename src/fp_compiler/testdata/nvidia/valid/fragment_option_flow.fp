!!ARBfp1.0
OPTION NV_fragment_program2;
TEMP a, b, n;
PARAM three = { 3, 0, 1, 0 };
MOV a, 0;
LOOP three;
  ADD a, a, fragment.texcoord[A0.x];
  SGTC n.x, a, 4;
  BRK (NE.x);
ENDLOOP;
REP 2;
  MUL a, a, 0.5;
ENDREP;
SGEC n.x, fragment.facing.x, 0;
IF NE.x;
  CAL front;
ELSE;
  DIV b, a, three.x;
  NRM b.xyz, b;
ENDIF;
TXL a, b, texture[1], CUBE;
MUL result.color, a, b;
RET;
front:
  DP2A b, a, a, a.x;
  RET;
END
