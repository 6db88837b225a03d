!!ARBfp1.0
# Rings about a point of the picture.
PARAM centre = program.local[0];
PARAM ring = program.local[1];    # frequency, phase, height
TEMP way, ripple;
SUB way.xyz, fragment.texcoord[0], centre;
DP3 way.w, way, way;
RSQ way.w, way.w;
RCP way.w, way.w;
MAD way.w, way.w, ring.x, ring.y;
SIN ripple.x, way.w;
MUL ripple.x, ripple.x, ring.z;
MAD way.xy, way, ripple.x, fragment.texcoord[0];
TEX result.color, way, texture[0], 2D;
END
