"""Cube maps at computed coordinates, 3D and rectangle textures, shadows, LOD biases."""

from OpenGL.GL.ARB.texture_rectangle import *
from stage import *

MIRROR = """
OPTION ARB_precision_hint_fastest;
TEMP n, e, r, c, b;
TEX n, fragment.texcoord[0], texture[0], 2D;
MAD n, n, 2.0, -1.0;
ADD n.z, n.z, 2.0;
DP3 n.w, n, n;
RSQ n.w, n.w;
MUL n.xyz, n, n.w;
DP3 e.x, n, fragment.texcoord[1];
ADD e.x, e.x, e.x;
MAD r.xyz, e.x, n, -fragment.texcoord[1];
TEX c, r, texture[1], CUBE;
MOV r.w, 2.0;
TXB b, r, texture[1], CUBE;
LRP result.color, 0.7, c, b;
"""
WOOD = """
TEMP p, c;
MUL p, fragment.texcoord[0], {0.8, 0.8, 0.8, 1};
TEX c, p, texture[0], 3D;
MUL result.color, c, {1.2, 0.9, 0.6, 1};
"""
STAMP = """
TEMP c;
TXP c, fragment.texcoord[0], texture[0], RECT;
KIL c.a;
SUB c.a, c.a, 0.598;
KIL c.a;
MOV result.color, c;
"""
SHADOW = """
OPTION ARB_fragment_program_shadow;
TEMP s;
TEX s, fragment.texcoord[0], texture[0], SHADOW2D;
MAD result.color, s, {0.6, 0.7, 0.4, 0}, {0.2, 0.2, 0.3, 1};
"""
FACES = (GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_CUBE_MAP_NEGATIVE_X,
         GL_TEXTURE_CUBE_MAP_POSITIVE_Y, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
         GL_TEXTURE_CUBE_MAP_POSITIVE_Z, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z)


def cube():
    name = glGenTextures(1)
    glBindTexture(GL_TEXTURE_CUBE_MAP, name)
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR)
    for face, target in enumerate(FACES):
        level, side = 0, 32
        while side:
            data = texels(side, side, lambda x, y: (
                (face & 1) * 0.5 + 0.5 * x / side, (face >> 1) / 3 + 0.3 * y / side,
                1 - face / 6, 1))
            glTexImage2D(target, level, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, data)
            level, side = level + 1, side // 2
    return name


def solid():
    name = glGenTextures(1)
    glBindTexture(GL_TEXTURE_3D, name)
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
    data = texels(16, 256, lambda x, y: (0.5 + 0.5 * math.sin(
        math.hypot(x - 7.5, y % 16 - 7.5) * 2 + y // 64), 0.5, 0.3, 1))
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 16, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, data)
    return name


def depths():
    name = glGenTextures(1)
    glBindTexture(GL_TEXTURE_2D, name)
    for what, value in ((GL_TEXTURE_MIN_FILTER, GL_NEAREST), (GL_TEXTURE_MAG_FILTER, GL_NEAREST),
                        (GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE),
                        (GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL)):
        glTexParameteri(GL_TEXTURE_2D, what, value)
    data = floats(0.5 + 0.4 * math.sin(x * 0.4) * math.cos(y * 0.3)
                  for y in range(32) for x in range(32))
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 32, 32, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 data)
    return name


def prepare():
    bumps = texture(64, 64, lambda x, y: (0.5 + 0.4 * math.sin(x * 0.6), 0.5 + 0.4 * math.sin(
        y * 0.45), 0.5, 1))
    return (bumps, cube(), solid(), texture(50, 30, checks, GL_LINEAR, GL_TEXTURE_RECTANGLE_ARB),
            depths(), [fragment(text) for text in (MIRROR, WOOD, STAMP, SHADOW)])


def bind(unit, target, name):
    glActiveTextureARB(GL_TEXTURE0_ARB + unit)
    glBindTexture(target, name)
    glActiveTextureARB(GL_TEXTURE0_ARB)


def corners(frame, coordinates):
    """Draws a quad; coordinates(x, y) returns those of unit 0, unit 1 gets a rotating direction."""
    a = 0.2 * frame
    glBegin(GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glMultiTexCoord4fARB(GL_TEXTURE0_ARB, *coordinates(x, y))
        glMultiTexCoord3fARB(GL_TEXTURE1_ARB, x + math.sin(a), y + math.cos(a), 1.5)
        glVertex2f(x, y)
    glEnd()


def draw(frame, prepared):
    bumps, cube_name, solid_name, rectangle, shadow, (mirror, wood, stamp, shade) = prepared
    flat()
    glClearColor(0.3, 0.3, 0.3, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    width, height = SIZE[0] // 2, SIZE[1] // 2
    move = frame / FRAMES
    bind(0, GL_TEXTURE_2D, bumps)
    bind(1, GL_TEXTURE_CUBE_MAP, cube_name)
    glViewport(0, height, width, height)
    use(mirror)
    corners(frame, lambda x, y: (x, y + move, 0, 1))
    bind(0, GL_TEXTURE_3D, solid_name)
    glViewport(width, height, width, height)
    use(wood)
    corners(frame, lambda x, y: (x, y, move + x * y, 1))
    bind(0, GL_TEXTURE_RECTANGLE_ARB, rectangle)
    glViewport(0, 0, width, height)
    use(stamp)
    corners(frame, lambda x, y: (25 + 25 * x, 15 + 15 * y, 0, 1 + 0.3 * move * x))
    bind(0, GL_TEXTURE_2D, shadow)
    glViewport(width, 0, width, height)
    use(shade)
    # The offset keeps pixel centers off the borders of texels, where either texel is right.
    corners(frame, lambda x, y: (x + 0.003, y + 0.003, move, 1))
    use()


play("targets", prepare, draw)
