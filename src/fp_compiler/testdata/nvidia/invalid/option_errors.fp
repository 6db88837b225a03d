!!ARBfp1.0
OPTION NV_fragment_program;
TEMP r;
IF GT.x;
ENDIF;
MOVQ r, r;
MOV r (GT.xz), r;
DDX_SAT r, r, r;
KIL GT.x, r;
END
