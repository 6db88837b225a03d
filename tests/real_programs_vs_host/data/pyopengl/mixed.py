"""Uses fixed function, programs, signed textures and GLSL in one frame with one depth buffer."""

from OpenGL.GL.shaders import compileProgram, compileShader
from stage import *

FOGGED = """
OPTION ARB_fog_linear;
TEMP c;
TEX c, fragment.texcoord[0], texture[0], 2D;
MUL result.color, c, fragment.color;
"""
SHINE = """
TEMP c;
TEX c, fragment.texcoord[0], texture[0], 2D;
ADD c, c, fragment.color.secondary;
LIT c.yz, {0.7, 0.4, 0, 20};
MOV result.color, c;
"""
GLSL = """
uniform sampler2D image;
void main() { gl_FragColor = texture2D(image, gl_TexCoord[0].st).bgra; }
"""


def prepare():
    rough = mipmapped(64, checks, internal=GL_RGBA8_SNORM)
    smooth = mipmapped(64, rings)
    shader = compileProgram(compileShader(GLSL, GL_FRAGMENT_SHADER))
    glFogi(GL_FOG_MODE, GL_LINEAR)
    glFogf(GL_FOG_START, 3)
    glFogf(GL_FOG_END, 7)
    glFogfv(GL_FOG_COLOR, floats((0.4, 0.5, 0.6, 1)))
    glLightfv(GL_LIGHT0, GL_POSITION, floats((1, 2, 3, 0)))
    return rough, smooth, shader, fragment(FOGGED), fragment(SHINE)


def ground(name, depth=-0.7):
    glBindTexture(GL_TEXTURE_2D, name)
    glPushMatrix()
    glRotatef(-90, 1, 0, 0)
    square(-4, -4, 4, 4, depth)
    glPopMatrix()


def draw(frame, prepared):
    rough, smooth, shader, fogged, shine = prepared
    glClearColor(0.4, 0.5, 0.6, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    set_view(frame)
    glColor3f(1, 1, 1)
    use(fogged)
    ground(rough)  # signed, a format that the rasterizer lacks
    ground(smooth, 1.6)
    use()
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glPushMatrix()
    glTranslatef(-1, 0, 0)
    glutSolidSphere(0.5, 16, 12)
    glPopMatrix()
    glDisable(GL_LIGHTING)
    glUseProgram(shader)
    glBindTexture(GL_TEXTURE_2D, smooth)
    square(0.2, -0.5, 1.2, 0.5, 0.3)
    glUseProgram(0)
    over(frame, rough, shine)


def over(frame, rough, shine):
    """Draws above the scene with blending, stencil and alpha test."""
    use(shine)
    glEnable(GL_STENCIL_TEST)
    glStencilFunc(GL_ALWAYS, 1, 255)
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE)
    glSecondaryColor3f(0.3, 0.1 * (frame % 5), 0.5)
    glEnable(GL_ALPHA_TEST)
    glAlphaFunc(GL_GREATER, 0.7)
    square(-0.6, -0.6, 0.2, 0.4, 0.8)
    glDisable(GL_ALPHA_TEST)
    glStencilFunc(GL_EQUAL, 1, 255)
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
    if frame % 2:
        use()  # every other frame ends with fixed function
    glColor4f(1, 0.2, 0.2, 0.6)
    flat()
    square(-0.5, -0.8, 0.5, 0.2, -0.9)
    glDisable(GL_BLEND)
    glDisable(GL_STENCIL_TEST)
    use()


play("mixed", prepare, draw)
