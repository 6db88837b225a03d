!!ARBfp1.0
#@ texture 0 = picture packed, nearest, repeat
#@ texture 1 = rule, nearest, edge
#@ texcoord 1 = st 0 0.0078125, texcoord 2 = st 0 -0.0078125
# Conway's Life with its work moved into textures. A texel of the board holds three cells of its
# row: red the one to the west, green its own, blue the one to the east. Three samples are then
# all nine cells, and a table two texels wide holds the rule: its column is the cell, its row how
# many of the nine are alive.
PARAM ones = {1.0, 1.0, 1.0, 0.0};
PARAM scale = {0.5, 0.0625, 0.0, 0.0};
PARAM centre = {0.25, 0.03125, 0.0, 0.0};
TEMP north, self, south, cell;
TEX self, fragment.texcoord[0], texture[0], 2D;
TEX north, fragment.texcoord[1], texture[0], 2D;
TEX south, fragment.texcoord[2], texture[0], 2D;
ADD cell, north, south;
ADD cell, cell, self;
DP3 cell.y, cell, ones;
MOV cell.x, self.y;
MAD cell, cell, scale, centre;
TEX result.color, cell, texture[1], 2D;
END
