"""Copies a picture from the window to a texture and draws it again, as trails and blurs do."""

from stage import *

FADE = """
TEMP a, b, sum;
PARAM step = program.local[0];
ADD a, fragment.texcoord[0], step;
SUB b, fragment.texcoord[0], step;
TEX sum, fragment.texcoord[0], texture[0], 2D;
TEX a, a, texture[0], 2D;
TEX b, b, texture[0], 2D;
ADD a, a, b;
MAD sum, a, 0.5, sum;
MUL result.color, sum, {0.49, 0.485, 0.48, 0.5};
"""
SPOT = """
TEMP d, r;
SUB d, fragment.texcoord[0], 0.5;
DP3 r.x, d, d;
MUL r.x, r.x, 16.0;
EX2 r.y, -r.x;
CMP r.y, r.x, 0.0, r.y;
MUL result.color, fragment.color, r.y;
MOV result.color.a, r.y;
"""


def prepare():
    back = texture(256, 128, None)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE)
    glViewport(0, 0, 256, 128)
    glClear(GL_COLOR_BUFFER_BIT)
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 256, 128)
    return back, fragment(FADE), fragment(SPOT)


def draw(frame, prepared):
    back, fade, spot = prepared
    flat()
    glBindTexture(GL_TEXTURE_2D, back)
    glViewport(0, 0, 256, 128)
    use(fade)
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 1 / 256, (frame % 3) / 128, 0, 0)
    square()
    use(spot)
    glEnable(GL_BLEND)
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA)
    for i in range(3):
        x = 0.7 * math.sin(0.31 * frame + 2.1 * i)
        y = 0.6 * math.cos(0.23 * frame + 1.3 * i)
        glColor3f(*(1.0 if c == i else 0.25 for c in range(3)))
        square(x - 0.2, y - 0.4, x + 0.2, y + 0.4)
    glDisable(GL_BLEND)
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 256, 128)
    # The shown picture is drawn from the copy by fixed function, upside down.
    use()
    glViewport(0, 0, *SIZE)
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_TEXTURE_2D)
    glColor3f(1, 1, 1)
    square(-0.95, 0.95, 0.95, -0.95)
    glDisable(GL_TEXTURE_2D)


play("feedback", prepare, draw)
