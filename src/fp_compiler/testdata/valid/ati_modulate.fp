!!ATIfs1.0
# one texture under the interpolated colour
StartOutputPass;
    SampleMap r0, t0.stq_dq;
    MUL r0, r0, color0;
EndPass;
