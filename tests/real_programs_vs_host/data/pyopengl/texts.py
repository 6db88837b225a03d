"""Draws a triangle in each frame, each with another text: every opcode of both languages, results, and mistakes.

A text that the host refuses leaves the previous one in its object. An object without a program
draws nothing, as that is an error.
"""

from stage import *

COLOUR = "fragment.color"
# Bodies of fragment programs; R is a temporary, C the color, T a coordinate from 0 to 1.
FRAGMENTS = (
    "ABS R, C; SUB R, R, 0.5; ABS result.color, R;",
    "ADD result.color, C, {0.25, 0.25}.x;",
    "ADD_SAT R, C, C; MUL result.color, R, 0.7;",
    "SUB R, C, 0.5; CMP result.color, R, {1, 0, 0, 1}, C;",
    "MUL R, C, 6.0; COS R.x, R.x; MAD result.color, R.x, 0.5, 0.5;",
    "DP3 result.color, C, {0.3, 0.5, 0.2};",
    "DP4 result.color, C, {0.3, 0.5, 0.2, 0.1};",
    "DPH result.color, C, {0.3, 0.5, 0.2, 0.1};",
    "DST R, C, T; MUL result.color, R, {0.5, 1, 1, 1};",
    "MUL R, C, -3.0; EX2 result.color, R.x;",
    "MUL R, C, 4.0; FLR R, R; MUL result.color, R, 0.25;",
    "MUL R, C, 4.0; FRC result.color, R;",
    "SUB R, C.x, 0.3; KIL R; MOV result.color, C;",
    "ADD R, C, 0.5; LG2 R.x, R.x; MAD result.color, R.x, 0.5, 0.5;",
    "MAD R, C, 2.0, -0.6; MOV R.w, 3.0; LIT result.color, R;",
    "LRP result.color, T.x, C, {0, 1, 0, 1};",
    "MAD result.color, C, T.y, 0.1;",
    "MAX result.color, C, T.x;",
    "MIN result.color, C, T.x;",
    "MOV result.color, C.bgra;",
    "MOV result.color, -C; ADD result.color, C, {0.1, 0.1, 0.1, 0};",
    "MUL result.color, C, T;",
    "POW R.x, C.x, {2.5}.x; MOV result.color, R.x;",
    "ADD R, C, 1.0; RCP result.color, R.y;",
    "ADD R, C, 1.0; RSQ result.color, R.z;",
    "MUL R, C, 3.0; SCS R.xy, R.x; MAD result.color, R.xyyy, 0.5, 0.5;",
    "SGE result.color, C, 0.4;",
    "MUL R, C, 6.0; SIN R.x, R.x; MAD result.color, R.x, 0.5, 0.5;",
    "SLT result.color, C, 0.4;",
    "SUB result.color, 1.0, C;",
    "SWZ result.color, C, 1, -x, 0, z;",
    "SWZ R, C, z, y, x, 1; MOV result.color, R;",
    "TEX result.color, T, texture[0], 2D;",
    "MOV R, T; MOV R.w, 2.0; TXP result.color, R, texture[0], 2D;",
    "MOV R, T; MOV R.w, 1.5; TXB result.color, R, texture[0], 2D;",
    "XPD R.xyz, C, T; MAD result.color, R.xyzz, 0.5, 0.5;",
    "MUL R, fragment.position, {0.003, 0.004, 1, 1}; MOV result.color, R;",
    "MOV result.color, C; MOV result.depth.z, T.x;",
    "PARAM p[3] = { program.local[0..1], {0.2, 0.3, 0.4, 1} }; MAD result.color, C, p[0], p[2];",
    "ALIAS out = R; OUTPUT half = result.color; MOV out, C; MUL half, out, state.light[0].diffuse;",
    "TEX R, T, texture[0], 2D; ADD R, R, T; TEX R, R, texture[0], 2D; MUL result.color, R, C;",
    "MOV R.x, C.x; MOV R.y, T.x; MOV R.zw, 0.5; MOV result.color, R;",
)
OPTIONS = (
    "OPTION ARB_fog_linear;", "OPTION ARB_fog_exp;", "OPTION ARB_fog_exp2;",
    "OPTION ARB_precision_hint_nicest;", "OPTION ARB_precision_hint_fastest;",
)
# Bodies of vertex programs; the position is written before, V is the position, C the color.
VERTICES = (
    "ABS R, C; MOV result.color, R;",
    "ADD result.color, C, 0.2;",
    "MUL R.x, C.x, 2.9; ARL A.x, R.x; MOV result.color, p[A.x + 1];",
    "DP3 result.color, C, {0.3, 0.5, 0.2};",
    "DP4 result.color, C, {0.3, 0.5, 0.2, 0.1};",
    "DPH result.color, C, {0.3, 0.5, 0.2, 0.1};",
    "DST result.color, C, C.yxzw;",
    "MUL R, C, -2.0; EX2 result.color, R.x;",
    "MUL R, C, -2.0; EXP R, R.x; MUL result.color, R, {1, 1, 1, 1};",
    "MUL R, C, 3.0; FLR R, R; MUL result.color, R, 0.3;",
    "MUL R, C, 2.5; FRC result.color, R;",
    "ADD R, C, 0.5; LG2 R.x, R.x; MAD result.color, R.x, 0.5, 0.5;",
    "MAD R, C, 2.0, -0.6; MOV R.w, 3.0; LIT result.color, R;",
    "ADD R, C, 0.5; LOG R, R.x; MAD result.color, R, 0.25, 0.5;",
    "MAD result.color, C, 0.7, 0.1;",
    "MAX result.color, C, 0.4;",
    "MIN result.color, C, 0.4;",
    "MOV result.color, C.zyxw;",
    "MUL result.color, C, {0.2, 0.9, 0.5, 1};",
    "ADD R, C, 0.1; POW result.color, R.x, {1.5}.x;",
    "ADD R, C, 1.0; RCP result.color, R.y;",
    "ADD R, C, 1.0; RSQ result.color, R.z;",
    "SGE result.color, C, 0.4;",
    "SLT result.color, C, 0.4;",
    "SUB result.color, 1.0, C;",
    "SWZ result.color, C, 1, -x, 0, z;",
    "XPD R.xyz, C, C.yzxw; MAD result.color, R.xyzz, 0.5, 0.5;",
    "MOV result.color, C; MOV result.pointsize.x, 4.0; MOV result.fogcoord.x, 2.0;",
    "MOV result.color, C; MOV result.color.secondary, {0.3, 0, 0, 0}; MOV result.texcoord[0], V;",
    "PARAM m[4] = { state.matrix.mvp }; DP4 R.x, m[0], V; MAD result.color, R.x, 0.3, 0.4;",
    "MOV result.color, vertex.attrib[6].zyxw;",
)
# Whole texts that must be refused.
MISTAKES = (
    "!!ARBfp1.0 MOV result.color, fragment.colour; END",
    "!!ARBfp1.0 MOV result.color, fragment.color END",
    "!!ARBfp1.0 TEMP r; MOV r, fragment.color; MOV result.colour, r; END",
    "!!ARBfp1.0 MOV result.color, fragment.color;",
    "!!ARBfp1.0 TEMP a; TEMP a; MOV result.color, fragment.color; END",
    "!!ARBfp1.0 TEX result.color, fragment.texcoord[0], texture[99], 2D; END",
    "!!ARBfp1.0 ARL result.color, fragment.color; END",
    "!!ARBfp1.0 SWZ result.color, fragment.color, x, y, z; END",
    "!!ARBfp1.0 RCP result.color, fragment.color; END",
    "!!ARBfp2.0 MOV result.color, fragment.color; END",
    "!!ARBfp1.0 OPTION ARB_no_such_thing; MOV result.color, fragment.color; END",
    "!!ARBfp1.0 PARAM p = {1, 2, 3, 4, 5}; MOV result.color, p; END",
    "",
)


def fragments():
    head = "TEMP R; ATTRIB C = fragment.color; ATTRIB T = fragment.texcoord[0];\n"
    texts = [f"!!ARBfp1.0\n{head}{body}\nEND" for body in FRAGMENTS]
    plain = "MOV result.color, fragment.color;"
    return texts + [f"!!ARBfp1.0\n{option}\n{plain}\nEND" for option in OPTIONS]


def vertices():
    head = ("TEMP R; ADDRESS A; ATTRIB V = vertex.position; ATTRIB C = vertex.color;\n"
            "PARAM p[4] = { program.env[0..2], {0.9, 0.6, 0.1, 1} };\n"
            "PARAM rows[4] = { state.matrix.mvp };\n"
            "DP4 result.position.x, rows[0], V; DP4 result.position.y, rows[1], V;\n"
            "DP4 result.position.z, rows[2], V; DP4 result.position.w, rows[3], V;\n")
    whole = [f"!!ARBvp1.0\n{head}{body}\nEND" for body in VERTICES]
    return whole + ["!!ARBvp1.0\nOPTION ARB_position_invariant;\n"
                    "MUL result.color, vertex.color, 0.8;\nEND"]


def refused(text: str) -> int:
    """Returns a program object whose text was refused; SystemExit if it was not."""
    names = (GLuint * 1)()
    glGenProgramsARB(1, names)
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, names[0])
    data = text.encode()
    try:
        glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, len(data), data)
    except GLError:
        return names[0]
    raise SystemExit(f"loaded though it is wrong: {text!r}")


def prepare():
    mipmapped(64, rings)
    glFogfv(GL_FOG_COLOR, floats((0.8, 0.4, 0.1, 1)))
    glFogf(GL_FOG_START, -1.0)
    glFogf(GL_FOG_END, 3.0)
    for i in range(3):
        glProgramEnvParameter4fARB(GL_VERTEX_PROGRAM_ARB, i, 0.3 * i, 1 - 0.3 * i, 0.5, 1)
    frames = [(program(GL_FRAGMENT_PROGRAM_ARB, text), 0) for text in fragments()]
    for name, _ in frames:
        glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, name)
        glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 0.5, 0.8, 0.3, 1)
    frames += [(0, program(GL_VERTEX_PROGRAM_ARB, text)) for text in vertices()]
    return frames + [(refused(text), 0) for text in MISTAKES]


def triangle():
    glBegin(GL_TRIANGLES)
    for x, y, colour in ((-0.9, -0.9, (0.9, 0.1, 0.2)), (0.9, -0.9, (0.1, 0.8, 0.3)),
                         (0.0, 0.9, (0.2, 0.3, 0.95))):
        glColor3f(*colour)
        glVertexAttrib4fARB(6, *colour, 1)
        glTexCoord2f(0.5 + x / 2, 0.5 + y / 2)
        glVertex3f(x, y, 0.2 * x)
    glEnd()


def draw(frame, frames):
    glClearColor(0.3, 0.3, 0.4, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    flat()
    use(*frames[frame])
    try:
        triangle()
    except GLError:
        if frame < len(frames) - len(MISTAKES):
            raise
    use()


if __name__ == "__main__":
    play("texts", prepare, draw, len(fragments()) + len(vertices()) + len(MISTAKES))
