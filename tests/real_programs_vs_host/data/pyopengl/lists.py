"""Display lists that bind programs, set their parameters, and call one another."""

from stage import *

LIT = """
PARAM light = program.local[0];
TEMP n, l, d, base;
DP3 n.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ n.w, n.w;
MUL n.xyz, fragment.texcoord[1], n.w;
DP3_SAT d.x, n, light;
TEX base, fragment.texcoord[0], texture[0], 2D;
MAD d.y, d.x, 0.8, 0.2;
MUL base, base, fragment.color;
MUL result.color, base, d.y;
"""
TURNED = """
OPTION ARB_position_invariant;
PARAM mv[3] = { state.matrix.modelview.invtrans.row[0..2] };
DP3 result.texcoord[1].x, mv[0], vertex.normal;
DP3 result.texcoord[1].y, mv[1], vertex.normal;
DP3 result.texcoord[1].z, mv[2], vertex.normal;
MOV result.texcoord[0], vertex.texcoord[0];
MOV result.color, vertex.color;
"""
FACES = (((0, 0, 1), (1, 0, 0)), ((0, 0, -1), (-1, 0, 0)), ((1, 0, 0), (0, 0, -1)),
         ((-1, 0, 0), (0, 0, 1)), ((0, 1, 0), (1, 0, 0)), ((0, -1, 0), (-1, 0, 0)))


def box(size):
    glBegin(GL_QUADS)
    for n, u in FACES:
        v = (n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0])
        glNormal3f(*n)
        for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            glTexCoord2f(s * 0.5 + 0.5, t * 0.5 + 0.5)
            glVertex3f(*(size * (n[i] + s * u[i] + t * v[i]) for i in range(3)))
    glEnd()


def prepare():
    image = mipmapped(64, rings)
    lit, turned = fragment(LIT), vertex(TURNED)
    first = glGenLists(4)
    glNewList(first, GL_COMPILE)
    box(0.4)
    glEndList()
    glNewList(first + 1, GL_COMPILE)
    use(lit, turned)
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 0.48, 0.6, 0.64, 0)
    glBindTexture(GL_TEXTURE_2D, image)
    glColor3f(1, 1, 1)
    glCallList(first)
    glEndList()
    glNewList(first + 2, GL_COMPILE)
    glPushAttrib(GL_ENABLE_BIT | GL_CURRENT_BIT)
    glDisable(GL_FRAGMENT_PROGRAM_ARB)
    glDisable(GL_VERTEX_PROGRAM_ARB)
    glColor3f(0.9, 0.5, 0.2)
    glCallList(first)
    glPopAttrib()
    glCallList(first)
    glEndList()
    glNewList(first + 3, GL_COMPILE)
    glPushMatrix()
    glTranslatef(1.1, 0, 0)
    glCallList(first + 1)
    glTranslatef(-2.2, 0, 0)
    glColor3f(0.5, 1, 0.5)
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, -0.6, 0, 0.8, 0)
    glCallList(first)
    glPopMatrix()
    glEndList()
    return first


def draw(frame, first):
    glClearColor(0.1, 0.1, 0.15, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    set_view(frame)
    glCallList(first + 3)
    glTranslatef(0, 0.9, 0)
    glCallList(first + 2)
    glTranslatef(0, -1.8, 0)
    glCallLists(2, GL_UNSIGNED_BYTE, bytes((first + 1, first + 2)))
    # One box is drawn without a list, with the lists' state: draws within the host's lists are not counted.
    glTranslatef(0, 0.9, 1.2)
    box(0.15)
    use()


play("lists", prepare, draw)
