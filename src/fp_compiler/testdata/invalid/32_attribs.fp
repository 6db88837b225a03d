!!ARBfp1.0
KIL fragment.texcoord[0];
KIL fragment.texcoord[1];
KIL fragment.texcoord[2];
KIL fragment.texcoord[3];
KIL fragment.texcoord[4];
KIL fragment.texcoord[5];
KIL fragment.texcoord[6];
KIL fragment.texcoord[7];
KIL fragment.color;
KIL fragment.color.secondary;
KIL fragment.position;
END
