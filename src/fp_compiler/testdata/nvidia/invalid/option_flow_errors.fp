!!ARBfp1.0
OPTION NV_fragment_program2;
TEMP r;
LOOP r;
ELSE;
BRK (GT.x);
ENDREP;
BRK;
MOV r, fragment.texcoord[A0.x + 10];
CAL missing;
ENDIF;
END
