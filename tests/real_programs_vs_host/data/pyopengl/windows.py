"""Two contexts share textures and programs, in two windows, one of which is resized."""

from OpenGL import GLX
from stage import *

PAINT = """
TEMP t;
TEX t, fragment.texcoord[0], texture[0], 2D;
MAD t, t, program.env[0], program.local[0];
MOV result.color, t;
"""


def main():
    glutInit([])
    first = window("windows-1")
    second = window("windows-2", (160, 200))
    glutMainLoopEvent()
    # GLUT's windows share nothing, so that another context is made that shares with the first.
    glutSetWindow(first)
    display, drawable = GLX.glXGetCurrentDisplay(), GLX.glXGetCurrentDrawable()
    own = GLX.glXGetCurrentContext()
    attributes = (ctypes.c_int * 9)(GLX.GLX_RGBA, GLX.GLX_DOUBLEBUFFER, GLX.GLX_RED_SIZE, 8,
                                    GLX.GLX_DEPTH_SIZE, 24, GLX.GLX_STENCIL_SIZE, 8, 0)
    visual = GLX.glXChooseVisual(display, 0, attributes)
    other = GLX.glXCreateContext(display, visual, own, True)
    glutSetWindow(second)
    second_drawable = GLX.glXGetCurrentDrawable()
    GLX.glXMakeCurrent(display, drawable, own)
    image = texture(64, 64, rings)
    paint = fragment(PAINT)
    for frame in range(FRAMES):
        GLX.glXMakeCurrent(display, drawable, own)
        half(frame, image, paint, SIZE)
        GLX.glXSwapBuffers(display, drawable)
        if frame == 8:
            glutSetWindow(second)
            glutReshapeWindow(240, 120)
            glutMainLoopEvent()
        GLX.glXMakeCurrent(display, second_drawable, other)
        if frame % 5 == 2:
            glBindTexture(GL_TEXTURE_2D, image)
            side = 32 if frame % 2 else 64
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         texels(side, side, checks))
            glFinish()
        half(frame + 7, image, paint, (240, 120) if frame >= 8 else (160, 200))
        GLX.glXSwapBuffers(display, second_drawable)
        glutMainLoopEvent()
    GLX.glXMakeCurrent(display, drawable, own)
    GLX.glXDestroyContext(display, other)


def half(frame, image, paint, size):
    glViewport(0, 0, *size)
    flat()
    glClearColor(0.2, 0.1 * (frame % 6), 0.2, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glBindTexture(GL_TEXTURE_2D, image)
    glColor3f(1, 1, 1)
    use(paint)
    glProgramEnvParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 1, 0.5 + 0.02 * frame, 0.8, 1)
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 0.01 * frame, 0, 0.1, 0)
    square(-0.9, -0.9, 0.9, 0.4)
    use()
    glEnable(GL_TEXTURE_2D)
    square(-0.5, 0.0, 0.9, 0.9)
    glDisable(GL_TEXTURE_2D)


main()
