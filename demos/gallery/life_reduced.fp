!!ARBfp1.0
#@ title "Life, reduced", size 128 128, rate 20
#@ target packed 128 128, then life_reduced_rule.fp
#@ texture 0 = feedback of cells 128 128 density 0.3, nearest, repeat
#@ texcoord 1 = st -0.0078125 0, texcoord 2 = st 0.0078125 0
# Gathers a cell and its two neighbours in the row into one texel, for the second pass.
TEMP west, self, east;
TEX self, fragment.texcoord[0], texture[0], 2D;
TEX west, fragment.texcoord[1], texture[0], 2D;
TEX east, fragment.texcoord[2], texture[0], 2D;
MOV self.y, self.x;
MOV self.x, west.x;
MOV self.z, east.x;
MOV result.color, self;
END
