"""Shared parts of the PyOpenGL clients: a window, a loop of a fixed number of frames, programs, textures.

The clients are recorded, so nothing in them depends on time, chance or the window manager.
"""

import ctypes
import math

from OpenGL.GL import *
from OpenGL.GL.ARB.fragment_program import *
from OpenGL.GL.ARB.multitexture import *
from OpenGL.GL.ARB.vertex_program import *
from OpenGL.GLUT import *

FRAMES = 20
SIZE = (320, 240)


def window(title: str, size=SIZE, more: int = 0) -> int:
    """Opens a window with depth and stencil buffer and makes its context current."""
    glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL | more)
    glutInitWindowSize(*size)
    name = glutCreateWindow(title.encode())
    glutDisplayFunc(lambda: None)
    return name


def play(title: str, prepare, draw, frames: int = FRAMES) -> None:
    """Calls draw(frame, prepare()) before each swap.

    An empty frame comes first: glretrace makes windows small and resizes them when a viewport is set,
    so that the first frame of a recording may be lost on any host.
    """
    glutInit([])
    window(title)
    glutMainLoopEvent()
    glViewport(0, 0, *SIZE)
    glClear(GL_COLOR_BUFFER_BIT)
    glutSwapBuffers()
    prepared = prepare()
    for frame in range(frames):
        draw(frame, prepared)
        glutSwapBuffers()
        glutMainLoopEvent()
        error = glGetError()
        if error:
            raise SystemExit(f"{title}: GL error {error:#x} in frame {frame}")


def program(target: int, text: str) -> int:
    """Returns a program object with the text; SystemExit with the host's message if it is refused."""
    names = (GLuint * 1)()
    glGenProgramsARB(1, names)
    name = names[0]
    glBindProgramARB(target, name)
    data = text.strip().encode()
    try:
        glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, len(data), data)
    except GLError:
        raise SystemExit(f"{glGetString(GL_PROGRAM_ERROR_STRING_ARB)!r} in\n{text}") from None
    return name


def fragment(body: str) -> int:
    return program(GL_FRAGMENT_PROGRAM_ARB, f"!!ARBfp1.0\n{body}\nEND")


def vertex(body: str) -> int:
    return program(GL_VERTEX_PROGRAM_ARB, f"!!ARBvp1.0\n{body}\nEND")


def use(fragment_name: int = 0, vertex_name: int = 0) -> None:
    """Makes the programs current; a stage without one is fixed function."""
    for target, name in ((GL_FRAGMENT_PROGRAM_ARB, fragment_name),
                         (GL_VERTEX_PROGRAM_ARB, vertex_name)):
        if name:
            glEnable(target)
            glBindProgramARB(target, name)
        else:
            glDisable(target)


def texels(width: int, height: int, colour) -> bytes:
    """Returns RGBA bytes of a picture; colour(x, y) returns four numbers from 0 to 1."""
    return bytes(min(255, max(0, int(255 * c + 0.5)))
                 for y in range(height) for x in range(width) for c in colour(x, y))


def texture(width: int, height: int, colour, filtering: int = GL_LINEAR,
            target: int = GL_TEXTURE_2D, internal: int = GL_RGBA8) -> int:
    name = glGenTextures(1)
    glBindTexture(target, name)
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filtering)
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR)
    data = texels(width, height, colour) if colour else None
    glTexImage2D(target, 0, internal, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, data)
    return name


def mipmapped(size: int, colour, filtering: int = GL_LINEAR_MIPMAP_LINEAR, internal: int = GL_RGBA8) -> int:
    """Makes a 2D texture with all levels, each the mean of the one before."""
    name = texture(size, size, colour, filtering, internal=internal)
    above, side, level = texels(size, size, colour), size // 2, 1
    while side:
        row = side * 8
        above = bytes(
            (above[y + x] + above[y + x + 4] + above[y + row + x] + above[y + row + x + 4] + 2) // 4
            for y in range(0, 2 * side * row, 2 * row)
            for s in range(0, row, 8) for x in range(s, s + 4))
        glTexImage2D(GL_TEXTURE_2D, level, internal, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, above)
        level, side = level + 1, side // 2
    return name


def checks(x: int, y: int):
    return (1, 0.9, 0.4, 1) if (x // 4 + y // 4) % 2 else (0.1, 0.3, 0.7, 0.5)


def rings(x: int, y: int):
    d = math.hypot(x - 31.5, y - 31.5) / 6
    return 0.5 + 0.5 * math.sin(d), 0.5 + 0.5 * math.cos(d * 1.7), x / 64, 1


def square(left=-1.0, bottom=-1.0, right=1.0, top=1.0, depth=0.0, unit: int = GL_TEXTURE0) -> None:
    """Draws a quad with texture coordinates 0 to 1."""
    glBegin(GL_QUADS)
    for s, t, x, y in ((0, 0, left, bottom), (1, 0, right, bottom), (1, 1, right, top),
                       (0, 1, left, top)):
        glMultiTexCoord2fARB(unit, s, t)
        glVertex3f(x, y, depth)
    glEnd()


def set_view(frame: int, distance: float = 4.0) -> None:
    """Sets a perspective view that rotates by a fixed step a frame."""
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glFrustum(-0.667, 0.667, -0.5, 0.5, 1.0, 20.0)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glTranslatef(0, 0, -distance)
    glRotatef(20, 1, 0, 0)
    glRotatef(9.0 * frame, 0, 1, 0)


def flat() -> None:
    """Sets window coordinates from -1 to 1."""
    for mode in (GL_PROJECTION, GL_MODELVIEW):
        glMatrixMode(mode)
        glLoadIdentity()


def floats(values) -> ctypes.Array:
    values = list(values)
    return (ctypes.c_float * len(values))(*values)
