!!ATIfs1.0
StartConstants;
    CONSTANT c0 = program.env[0];
    CONSTANT c1 = program.local[7];
    CONSTANT c2 = { 0.5 };
    CONSTANT c7 = { 0.25, 0.5, 0.75, 1 };
EndConstants;
StartOutputPass;
    MAD r0.rgb, c0, c1.r, color1;
    MOV r0.a, c0;
    LERP r0, c7.a.comp, c2, r0;
EndPass;
