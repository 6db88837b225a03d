!!ARBfp1.0
#@ title "Life, in its own words", size 128 128, rate 20
#@ texture 0 = feedback of cells 128 128 density 0.3, nearest, repeat
#@ local[0] = 0.0078125 0.0078125 -0.0078125 0
# Conway's Life as one would say it: look at the eight neighbours, add them up, apply the rule.
# Red is the cell. White is alive; a trail fades where a cell has died.
PARAM step = program.local[0];    # 1/width, 1/height, -1/width, 0
PARAM rule = {0.5, 2.0, 3.0, 0.03137254901960784};    # w: 8/255, the fading
ATTRIB here = fragment.texcoord[0];
TEMP self, n, ne, e, se, s, sw, w, nw, count, stays, next;

ADD n, here, step.wyww;
ADD ne, here, step.xyww;
ADD e, here, step.xwww;
ADD se, here, -step.zyww;
ADD s, here, -step.wyww;
ADD sw, here, -step.xyww;
ADD w, here, step.zwww;
ADD nw, here, step.zyww;

TEX self, here, texture[0], 2D;
TEX n, n, texture[0], 2D;
TEX ne, ne, texture[0], 2D;
TEX e, e, texture[0], 2D;
TEX se, se, texture[0], 2D;
TEX s, s, texture[0], 2D;
TEX sw, sw, texture[0], 2D;
TEX w, w, texture[0], 2D;
TEX nw, nw, texture[0], 2D;

ADD count, n, ne;
ADD count, count, e;
ADD count, count, se;
ADD count, count, s;
ADD count, count, sw;
ADD count, count, w;
ADD count, count, nw;

# Three neighbours: alive, whatever it was.
SUB next.x, count.x, rule.z;
ABS next.x, next.x;
SLT next.x, next.x, rule.x;
# Two neighbours: as it was.
SUB stays.x, count.x, rule.y;
ABS stays.x, stays.x;
SLT stays.x, stays.x, rule.x;
SGE stays.y, self.x, rule.x;
MUL stays.x, stays.x, stays.y;
MAX next, next.x, stays.x;

SUB self.yz, self, rule.w;
MAX next.yz, next, self;
MOV result.color, next;
END
