!!ATIfs1.0
# a specular power from a table: (N.H)^2 / |H|^2 across, the exponent of each pixel up
StartPrelimPass;
    SampleMap    r1, t0.str;
    PassTexCoord r3, t3.str;
    SampleMap    r4, t4.str;
    SampleMap    r5, t0.str;
    DOT3 r4, r1.2x.bias, r4.2x.bias;          # N.L
    DOT3 r1, r1.2x.bias, r3;                  # N.H
    MUL  r1, r1, r1;
    DOT3 r1.b, r3, r3;
    MUL  r1.g.half, r1.b, r5.r;
EndPass;
StartOutputPass;
    SampleMap    r0, t0.str;
    SampleMap    r3, r1.str_dr;
    PassTexCoord r4, r4.str;
    MUL r3, r3, r4;
    MAD r0.rgb.sat, r0, r4, r3;
    MOV r0.a, 1;
EndPass;
