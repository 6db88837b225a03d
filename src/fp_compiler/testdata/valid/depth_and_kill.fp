!!ARBfp1.0
TEMP at;
SUB at, fragment.position.z, program.env[0];
KIL -at.xxyy;
MAD result.depth.z, at.z, 0.5, 0.5;
MOV result.color, fragment.color.secondary;
END
