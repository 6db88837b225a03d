!!ARBfp1.0
OPTION ARB_fragment_program_shadow;
OPTION ARB_fog_exp2;
# Targets, sampled in every way.
TEMP s0, s1, s2, s3, s4, s5, s6, s7, s8, s9, s10, s11, s12, s13, s14, s15;
TEX s0, fragment.texcoord[0], texture[0], 1D;
TXP s1, fragment.texcoord[0], texture[0], 1D;
TXB s2, fragment.texcoord[0], texture[0], 1D;
TXP s3, fragment.texcoord[1], texture[1], 2D;
TXB s4, fragment.texcoord[1], texture[1], 2D;
TXP s5, fragment.texcoord[2], texture[2], 3D;
TXB s6, fragment.texcoord[2], texture[2], 3D;
TXP_SAT s7.xw, fragment.texcoord[3], texture[3], CUBE;
TXB s8, fragment.texcoord[3], texture[3], CUBE;
TXB s9, fragment.texcoord[4], texture[4], RECT;
TXP s10, fragment.texcoord[4], texture[4], RECT;
TXP s11, fragment.texcoord[5], texture[5], SHADOW2D;
TXB s12, fragment.texcoord[5], texture[5], SHADOW2D;
TXB s13, -fragment.texcoord[6], texture[6], SHADOW1D;
TXP s14, fragment.texcoord[6], texture[6], SHADOW1D;
TXP s15, fragment.texcoord[7], texture[7], SHADOWRECT;
ADD s0, s0, s1;
ADD s0, s0, s2;
ADD s0, s0, s3;
ADD s0, s0, s4;
ADD s0, s0, s5;
ADD s0, s0, s6;
ADD s0, s0, s7;
ADD s0, s0, s8;
ADD s0, s0, s9;
ADD s0, s0, s10;
ADD s0, s0, s11;
ADD s0, s0, s12;
ADD s0, s0, s13;
ADD s0, s0, s14;
ADD s0, s0, s15;
MUL result.color, s0, 0.0625;
MOV result.depth.z, s12.x;
END
