!!ATIfs1.0
#@ title "Bumps and paints, an ATI text shader", size 512 512
#@ mesh torus, camera orbit pitch 35 distance 2.8, vertex ati_bumps.vp
#@ texcoord 1 = tangent, texcoord 2 = binormal
#@ texture 1 = normals strength 3 of bumps 256 256 count 8, linear
#@ texture 2 = gradient 64 1 low 0.25 high 1 power 0.8, linear, edge
#@ texture 3 = bricks 256 256 rows 16 columns 16, linear
# Two passes, as the language of the Radeon 8500 has them: what the first one makes of the light is
# the place in a table that the second one reads.
StartConstants;
    CONSTANT c0 = { 0.95, 0.85, 0.7, 1.0 };
EndConstants;
StartPrelimPass;
    PassTexCoord r0, t1.str;
    SampleMap r1, t0.str;
    DOT3 r0.rgb.sat, r0, r1.2x.bias;
    MOV r0.a, 1;
EndPass;
StartOutputPass;
    SampleMap r2, r0.str;
    SampleMap r3, t0.str;
    MUL r0.rgb, r2, r3;
    MOV r0.a, 1;
    MUL r0.rgb, r0, c0;
EndPass;
