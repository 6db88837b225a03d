!!ARBfp1.0
# Nine samples with nine weights.
TEMP c, n, ne, e, se, s, sw, w, nw;
ADD n.xy, fragment.texcoord[0], program.local[0];
ADD ne.xy, fragment.texcoord[0], program.local[1];
ADD e.xy, fragment.texcoord[0], program.local[2];
ADD se.xy, fragment.texcoord[0], program.local[3];
ADD s.xy, fragment.texcoord[0], program.local[4];
ADD sw.xy, fragment.texcoord[0], program.local[5];
ADD w.xy, fragment.texcoord[0], program.local[6];
ADD nw.xy, fragment.texcoord[0], program.local[7];
TEX c, fragment.texcoord[0], texture[0], 2D;
TEX n, n, texture[0], 2D;
TEX ne, ne, texture[0], 2D;
TEX e, e, texture[0], 2D;
TEX se, se, texture[0], 2D;
TEX s, s, texture[0], 2D;
TEX sw, sw, texture[0], 2D;
TEX w, w, texture[0], 2D;
TEX nw, nw, texture[0], 2D;
MUL c, c, program.env[0].x;
MAD c, n, program.env[0].y, c;
MAD c, ne, program.env[0].z, c;
MAD c, e, program.env[0].y, c;
MAD c, se, program.env[0].z, c;
MAD c, s, program.env[0].y, c;
MAD c, sw, program.env[0].z, c;
MAD c, w, program.env[0].y, c;
MAD result.color, nw, program.env[0].z, c;
END
