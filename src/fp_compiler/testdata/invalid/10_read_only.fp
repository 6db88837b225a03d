!!ARBfp1.0
PARAM p = 1;
ATTRIB c = fragment.color;
MOV p, c;
MOV c.x, p;
MOV fragment.position, p;
MOV program.env[0], p;
END
