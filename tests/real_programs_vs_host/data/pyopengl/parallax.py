"""Samples textures at whole levels, at coordinates from another texture's heights: the level of each
quad depends on which of its rows determines it. Draws to the window, and to a framebuffer object.
"""

from OpenGL.GL.EXT.framebuffer_object import *
from stage import *

SHIFTED = """
TEMP h, at;
TEX h, fragment.texcoord[0], texture[1], 2D;
MAD h, h, 0.5, -0.25;
MAD at, h, {0.5, 0.7, 0, 0}, fragment.texcoord[0];
TEX result.color, at, texture[0], 2D;
"""


def prepare():
    heights = texture(64, 64, lambda x, y: (0.5 + 0.5 * math.sin(0.9 * x + 0.3 * y),
                                            0.5 + 0.5 * math.sin(0.7 * y - 0.4 * x), 0, 1))
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT)
    # Each level has a color of its own, so that another level is another picture.
    colours = glGenTextures(1)
    glBindTexture(GL_TEXTURE_2D, colours)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST)
    for level in range(8):
        side = 128 >> level
        colour = (level % 2, (level // 2) % 2, 0.2 + 0.1 * level, 1)
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     texels(side, side, lambda x, y, c=colour: c))
    aside = texture(128, 96, None)
    buffer = glGenFramebuffersEXT(1)
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, buffer)
    glFramebufferTexture2DEXT(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D, aside, 0)
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, 0)
    return heights, colours, aside, buffer, fragment(SHIFTED)


def shifted(frame, heights, colours, name):
    glActiveTextureARB(GL_TEXTURE1_ARB)
    glBindTexture(GL_TEXTURE_2D, heights)
    glActiveTextureARB(GL_TEXTURE0_ARB)
    glBindTexture(GL_TEXTURE_2D, colours)
    glClearColor(0.2, 0.2, 0.2, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    set_view(0)
    glRotatef(3.0 * frame, 0, 0, 1)
    use(name)
    square(-1.6, -1.2, 1.6, 1.2, 1.0)
    use()


def draw(frame, prepared):
    heights, colours, aside, buffer, name = prepared
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, buffer)
    glViewport(0, 0, 128, 96)
    shifted(frame, heights, colours, name)
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, 0)
    glViewport(0, 0, *SIZE)
    shifted(frame, heights, colours, name)
    flat()
    glViewport(0, 0, 128, 96)
    glBindTexture(GL_TEXTURE_2D, aside)
    glEnable(GL_TEXTURE_2D)
    glColor3f(1, 1, 1)
    square()
    glDisable(GL_TEXTURE_2D)
    glViewport(0, 0, *SIZE)


play("parallax", prepare, draw, 8)
