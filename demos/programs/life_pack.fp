!!ARBfp1.0
# Gathers a cell and its two neighbours in the row into one texel, for life_packed.fp.
TEMP west, self, east;
TEX self, fragment.texcoord[0], texture[0], 2D;
TEX west, fragment.texcoord[1], texture[0], 2D;
TEX east, fragment.texcoord[2], texture[0], 2D;
MOV self.y, self.x;
MOV self.x, west.x;
MOV self.z, east.x;
MOV result.color, self;
END
