!!ATIfs1.0
# a normal map, turned by a matrix in three coordinate sets, looks up an environment
StartPrelimPass;
    PassTexCoord r0, t0.str;
    PassTexCoord r1, t1.str;
    PassTexCoord r2, t2.str;
    PassTexCoord r3, t3.str;                  # the eye
    SampleMap    r4, t5.str;
    DOT3 r5.r, r0, r4.2x.bias;
    DOT3 r5.g, r1, r4.2x.bias;
    DOT3 r5.b, r2, r4.2x.bias;
    DOT3 r4.2x, r5, r3;                       # 2 * (N . E)
    MAD  r5, r4, r5, r3.neg;                  # reflected, for a normal of length one
EndPass;
StartOutputPass;
    SampleMap r0, r5.str;
    MOV r0, r0;
EndPass;
