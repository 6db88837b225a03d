"""Framebuffer objects: a scene is drawn to two color textures at once, blurred, and composed."""

from OpenGL.GL.ARB.draw_buffers import *
from OpenGL.GL.EXT.framebuffer_object import *
from stage import *

SIDE = 128
SCENE = """
OPTION ARB_draw_buffers;
TEMP c, bright;
TEX c, fragment.texcoord[0], texture[0], 2D;
MUL c, c, fragment.color;
SUB_SAT bright, c, 0.55;
MOV result.color[0], c;
MUL result.color[1], bright, 2.0;
"""
BLUR = """
PARAM step = program.local[0];
TEMP sum, at, c;
TEX sum, fragment.texcoord[0], texture[0], 2D;
MUL sum, sum, 0.4;
MAD at, step, 1.5, fragment.texcoord[0];
TEX c, at, texture[0], 2D;
MAD sum, c, 0.2, sum;
MAD at, step, -1.5, fragment.texcoord[0];
TEX c, at, texture[0], 2D;
MAD sum, c, 0.2, sum;
MAD at, step, 3.5, fragment.texcoord[0];
TEX c, at, texture[0], 2D;
MAD sum, c, 0.1, sum;
MAD at, step, -3.5, fragment.texcoord[0];
TEX c, at, texture[0], 2D;
MAD result.color, c, 0.1, sum;
"""
JOIN = """
TEMP scene, glow;
TEX scene, fragment.texcoord[0], texture[0], 2D;
TEX glow, fragment.texcoord[0], texture[1], 2D;
MAD result.color, glow, 1.5, scene;
"""


def prepare():
    image = mipmapped(64, checks)
    targets = [texture(SIDE, SIDE, None) for _ in range(3)]
    for name in targets:
        glBindTexture(GL_TEXTURE_2D, name)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE)
    depth = glGenRenderbuffersEXT(1)
    glBindRenderbufferEXT(GL_RENDERBUFFER_EXT, depth)
    glRenderbufferStorageEXT(GL_RENDERBUFFER_EXT, GL_DEPTH_COMPONENT24, SIDE, SIDE)
    both, blur = glGenFramebuffersEXT(1), glGenFramebuffersEXT(1)
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, both)
    for i in range(2):
        glFramebufferTexture2DEXT(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT + i, GL_TEXTURE_2D,
                                  targets[i], 0)
    glFramebufferRenderbufferEXT(GL_FRAMEBUFFER_EXT, GL_DEPTH_ATTACHMENT_EXT,
                                 GL_RENDERBUFFER_EXT, depth)
    glDrawBuffersARB(2, (GLenum * 2)(GL_COLOR_ATTACHMENT0_EXT, GL_COLOR_ATTACHMENT0_EXT + 1))
    if glCheckFramebufferStatusEXT(GL_FRAMEBUFFER_EXT) != GL_FRAMEBUFFER_COMPLETE_EXT:
        raise SystemExit("framebuffers: not complete")
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, 0)
    return image, targets, both, blur, fragment(SCENE), fragment(BLUR), fragment(JOIN)


def scene(frame, image, program_name):
    glViewport(0, 0, SIDE, SIDE)
    glClearColor(0.1, 0.05, 0.2, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    set_view(frame)
    use(program_name)
    glBindTexture(GL_TEXTURE_2D, image)
    for i in range(4):
        glRotatef(90, 0, 1, 0)
        glColor3f(1, 0.5 + i / 6, 1 - i / 4)
        square(-0.8, -0.8, 0.8, 0.8, 0.9)
    glDisable(GL_DEPTH_TEST)


def blurred(source, target, step_x, step_y):
    glFramebufferTexture2DEXT(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D, target, 0)
    glBindTexture(GL_TEXTURE_2D, source)
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, step_x, step_y, 0, 0)
    square()


def draw(frame, prepared):
    image, targets, both, blur, scene_program, blur_program, join = prepared
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, both)
    scene(frame, image, scene_program)
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, blur)
    flat()
    use(blur_program)
    blurred(targets[1], targets[2], 1 / SIDE, 0)
    blurred(targets[2], targets[1], 0, 1 / SIDE)
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, 0)
    glViewport(0, 0, *SIZE)
    use(join)
    glActiveTextureARB(GL_TEXTURE1_ARB)
    glBindTexture(GL_TEXTURE_2D, targets[1])
    glActiveTextureARB(GL_TEXTURE0_ARB)
    glBindTexture(GL_TEXTURE_2D, targets[0])
    square()
    use()


play("framebuffers", prepare, draw)
