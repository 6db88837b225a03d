"""Buffer objects: vertices that a program bends by matrices from relative addressing, indices, streams."""

from OpenGL.GL.ARB.vertex_buffer_object import *
from stage import *

SKIN = """
ATTRIB weight = vertex.attrib[6];
PARAM bones[9] = { program.env[0..8] };
PARAM mvp[4] = { state.matrix.mvp };
ADDRESS a;
TEMP p, q;
ARL a.x, weight.x;
DP4 p.x, bones[a.x], vertex.position;
DP4 p.y, bones[a.x + 1], vertex.position;
DP4 p.z, bones[a.x + 2], vertex.position;
ARL a.x, weight.y;
DP4 q.x, bones[a.x], vertex.position;
DP4 q.y, bones[a.x + 1], vertex.position;
DP4 q.z, bones[a.x + 2], vertex.position;
SUB q, q, p;
MAD p.xyz, q, weight.z, p;
MOV p.w, 1.0;
DP4 result.position.x, mvp[0], p;
DP4 result.position.y, mvp[1], p;
DP4 result.position.z, mvp[2], p;
DP4 result.position.w, mvp[3], p;
MOV result.texcoord[0], vertex.texcoord[0];
MOV result.color, vertex.color;
"""
STRIPES = """
TEMP t, c;
FRC t.x, fragment.texcoord[0].y;
SGE t.y, t.x, 0.5;
TEX c, fragment.texcoord[0], texture[0], 2D;
LRP result.color, t.y, c, fragment.color;
"""
ROUND, TALL = 16, 24


def tube():
    """Returns position, texture coordinates, color and (first bone's row, second's, weight)."""
    out = []
    for j in range(TALL + 1):
        h = j / TALL
        for i in range(ROUND + 1):
            a = 2 * math.pi * i / ROUND
            bone = min(1, int(h * 2))
            out += [0.4 * math.cos(a), 2 * h - 1, 0.4 * math.sin(a), 2 * i / ROUND, 6 * h,
                    h, 0.6, 1 - h, 1, 3.0 * bone, 3.0 * bone + 3, h * 2 - bone, 0]
    return floats(out)


def prepare():
    texture(64, 64, rings)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT)
    names = (GLuint * 3)()
    glGenBuffersARB(3, names)
    data = tube()
    glBindBufferARB(GL_ARRAY_BUFFER_ARB, names[0])
    glBufferDataARB(GL_ARRAY_BUFFER_ARB, ctypes.sizeof(data), data, GL_STATIC_DRAW_ARB)
    strip = []
    for j in range(TALL):
        for i in range(ROUND + 1):
            strip += [j * (ROUND + 1) + i, (j + 1) * (ROUND + 1) + i]
        strip += [strip[-1], (j + 1) * (ROUND + 1)]
    indices = (ctypes.c_ushort * len(strip))(*strip)
    glBindBufferARB(GL_ELEMENT_ARRAY_BUFFER_ARB, names[1])
    glBufferDataARB(GL_ELEMENT_ARRAY_BUFFER_ARB, ctypes.sizeof(indices), indices,
                    GL_STATIC_DRAW_ARB)
    return names, len(strip), vertex(SKIN), fragment(STRIPES)


def bones(frame):
    for bone in range(3):
        a = 0.25 * bone * math.sin(0.4 * frame)
        rows = ((math.cos(a), -math.sin(a), 0, 0.3 * bone * math.sin(0.2 * frame)),
                (math.sin(a), math.cos(a), 0, 0), (0, 0, 1, 0))
        for row in range(3):
            glProgramEnvParameter4fARB(GL_VERTEX_PROGRAM_ARB, 3 * bone + row, *rows[row])


def draw(frame, prepared):
    names, count, skin, stripes = prepared
    glClearColor(0.05, 0.1, 0.1, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    set_view(frame)
    use(stripes, skin)
    bones(frame)
    glBindBufferARB(GL_ARRAY_BUFFER_ARB, names[0])
    glBindBufferARB(GL_ELEMENT_ARRAY_BUFFER_ARB, names[1])
    at, stride = ctypes.c_void_p, 13 * 4
    glVertexPointer(3, GL_FLOAT, stride, at(0))
    glTexCoordPointer(2, GL_FLOAT, stride, at(12))
    glColorPointer(4, GL_FLOAT, stride, at(20))
    glVertexAttribPointerARB(6, 4, GL_FLOAT, GL_FALSE, stride, at(36))
    for array in (GL_VERTEX_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY):
        glEnableClientState(array)
    glEnableVertexAttribArrayARB(6)
    glDrawElements(GL_TRIANGLE_STRIP, count, GL_UNSIGNED_SHORT, at(0))
    glDisableVertexAttribArrayARB(6)
    stream(frame, names[2])
    for array in (GL_VERTEX_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY):
        glDisableClientState(array)
    glBindBufferARB(GL_ARRAY_BUFFER_ARB, 0)
    glBindBufferARB(GL_ELEMENT_ARRAY_BUFFER_ARB, 0)
    use()


def stream(frame, name):
    """Draws a wave of lines, whose vertices overwrite the old ones in each frame."""
    points = []
    for i in range(60):
        x = i / 30 - 1
        points += [1.5 * x, -0.9 + 0.2 * math.sin(6 * x + 0.5 * frame), 0.5, x, 1 - x, 1, 1]
    data = floats(points)
    glBindBufferARB(GL_ARRAY_BUFFER_ARB, name)
    if frame % 4 == 0:
        glBufferDataARB(GL_ARRAY_BUFFER_ARB, ctypes.sizeof(data), data, GL_STREAM_DRAW_ARB)
    else:
        glBufferSubDataARB(GL_ARRAY_BUFFER_ARB, 0, ctypes.sizeof(data), data)
    glDisable(GL_VERTEX_PROGRAM_ARB)
    glDisableClientState(GL_TEXTURE_COORD_ARRAY)
    glVertexPointer(3, GL_FLOAT, 28, ctypes.c_void_p(0))
    glColorPointer(4, GL_FLOAT, 28, ctypes.c_void_p(12))
    glDrawArrays(GL_LINE_STRIP, 0, 60)
    glDrawArrays(GL_POINTS, 0, 60)


play("buffers", prepare, draw)
