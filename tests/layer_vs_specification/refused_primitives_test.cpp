// Setting state between Begin and End, and Begin there, are errors (OpenGL 2.1, 2.6.3) without any
// other effect: the primitive is drawn as if the command was missing.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "fixture.h"

namespace api {
namespace {

struct Command {
  const char *name;
  std::function<void()> run;
};

const GLfloat kValues[16] = {0.5f, 0.25f, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0.5f, 0, 0, 1};
const GLubyte kStipple[128] = {};

/// Returns commands that would change the picture of this primitive or of the next.
std::vector<Command> commands() {
  return {
      {"Begin of the mode", [] { glBegin(GL_TRIANGLES); }},
      {"Begin of another", [] { glBegin(GL_POINTS); }},
      {"Begin of none", [] { glBegin(GL_POLYGON + 1); }},
      {"LineWidth", [] { glLineWidth(7); }},
      {"PointSize", [] { glPointSize(7); }},
      {"ShadeModel", [] { glShadeModel(GL_FLAT); }},
      {"CullFace", [] { glCullFace(GL_FRONT_AND_BACK); }},
      {"PolygonMode", [] { glPolygonMode(GL_FRONT_AND_BACK, GL_POINT); }},
      {"PolygonStipple", [] { glPolygonStipple(kStipple); }},
      {"Enable CULL_FACE", [] { glEnable(GL_CULL_FACE), glEnable(GL_LIGHTING); }},
      {"Enable SCISSOR_TEST", [] { glEnable(GL_SCISSOR_TEST); }},
      {"Scissor", [] { glScissor(0, 0, 1, 1); }},
      {"Viewport", [] { glViewport(0, 0, 8, 8); }},
      {"DepthRange", [] { glDepthRange(1, 0); }},
      {"Disable DITHER", [] { glDisable(GL_DITHER); }},
      {"BlendFunc", [] { glBlendFunc(GL_ZERO, GL_ZERO); }},
      {"BlendEquation", [] { glBlendEquation(GL_FUNC_REVERSE_SUBTRACT); }},
      {"BlendColor", [] { glBlendColor(1, 1, 1, 1); }},
      {"AlphaFunc", [] { glAlphaFunc(GL_NEVER, 0); }},
      {"DepthFunc", [] { glDepthFunc(GL_NEVER); }},
      {"StencilFunc", [] { glStencilFunc(GL_NEVER, 0, 0); }},
      {"LogicOp", [] { glLogicOp(GL_CLEAR); }},
      {"ColorMask", [] { glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); }},
      {"MatrixMode", [] { glMatrixMode(GL_PROJECTION); }},
      {"LoadMatrix", [] { glLoadMatrixf(kValues); }},
      {"LoadIdentity", [] { glLoadIdentity(); }},
      {"MultMatrix", [] { glMultMatrixf(kValues); }},
      {"Rotate", [] { glRotatef(45, 0, 0, 1); }},
      {"Scale", [] { glScaled(0.5, 0.5, 1); }},
      {"Translate", [] { glTranslatef(0.5f, 0, 0); }},
      {"PushMatrix", [] { glPushMatrix(); }},
      {"PopMatrix", [] { glPopMatrix(); }},
      {"ClipPlane",
       [] {
         glClipPlane(GL_CLIP_PLANE0, std::array<GLdouble, 4>{-1, 0, 0, 0}.data());
       }},
      {"Light", [] { glLightfv(GL_LIGHT0, GL_DIFFUSE, kValues); }},
      {"LightModel", [] { glLightModelfv(GL_LIGHT_MODEL_AMBIENT, kValues); }},
      {"ColorMaterial", [] { glColorMaterial(GL_FRONT, GL_SPECULAR); }},
      {"Fog", [] { glFogf(GL_FOG_DENSITY, 4), glFogi(GL_FOG_MODE, GL_LINEAR); }},
      {"BindTexture", [] { glBindTexture(GL_TEXTURE_2D, 77); }},
      {"TexParameter", [] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); }},
      {"TexEnv", [] { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE); }},
      {"TexGen", [] { glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP); }},
      {"TexImage",
       [] {
         glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kStipple);
       }},
  };
}

class RefusedPrimitives : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    glViewport(0, 0, kSize, kSize);
    glEnable(GL_BLEND);
    glEnable(GL_TEXTURE_2D);
    const std::array<GLubyte, 16> texels = {255, 255, 0,   255, 255, 0,   255, 255,
                                            0,   255, 255, 255, 128, 128, 128, 255};
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    glMatrixMode(GL_MODELVIEW);
    glScalef(0.75f, 0.75f, 1);
  }

  /// Compares pictures. Either the host or the rasterizer may draw a frame, and they round colors
  /// differently.
  static void expectAlike(const Picture &picture, const Picture &wanted, const char *what) {
    int most = 0;
    for (std::size_t i = 0; i < picture.size(); ++i)
      most = std::max(most, std::abs(picture[i] - wanted[i]));
    EXPECT_LE(most, 3) << what;
  }
  static void vertex(float x, float y) {
    glColor4f(0.5f + x / 2, 1, 0.5f + y / 2, 0.75f);
    glTexCoord2f(x, y);
    glVertex2f(x, y);
  }
  /// Draws two triangles, the first with the command in it, then lines and points.
  static Picture drawn(const std::function<void()> &command) {
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    vertex(-0.9f, -0.9f), vertex(0.9f, -0.9f);
    if (command)
      command();
    vertex(0.9f, 0.9f);
    glEnd();
    const GLenum error = glGetError();
    EXPECT_EQ(error, GLenum(command ? GL_INVALID_OPERATION : GL_NO_ERROR));
    glBegin(GL_TRIANGLES);
    vertex(-0.9f, -0.9f), vertex(0.3f, 0.9f), vertex(-0.9f, 0.9f);
    glEnd();
    glBegin(GL_LINES);
    vertex(-0.9f, -0.2f), vertex(0.9f, 0.1f);
    glEnd();
    glBegin(GL_POINTS);
    vertex(0.7f, -0.7f);
    glEnd();
    const Picture picture = readPicture(kSize);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    return picture;
  }
};

TEST_F(RefusedPrimitives, NothingComesOfStateSetWithinThem) {
  const Picture wanted = drawn(nullptr);
  EXPECT_NE(wanted, Picture(wanted.size()));
  for (const Command &command : commands())
    expectAlike(drawn(command.run), wanted, command.name);
}

TEST_F(RefusedPrimitives, AQueryIsAnsweredAfterwards) {
  glLineWidth(3);
  glBegin(GL_LINES);
  glLineWidth(5);
  vertex(0, 0), vertex(1, 1);
  glEnd();
  GLfloat width = 0;
  glGetFloatv(GL_LINE_WIDTH, &width);
  EXPECT_EQ(width, 3);
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
}

/// The first error since the last GetError counts (2.5).
TEST_F(RefusedPrimitives, AnEarlierErrorStaysTheFirst) {
  glLineWidth(-1);
  glBegin(GL_LINES);
  glLineWidth(5);
  vertex(0, 0), vertex(1, 1);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  glBegin(GL_LINES);
  glLineWidth(5);
  vertex(0, 0), vertex(1, 1);
  glEnd();
  glLineWidth(-1);
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

/// Some applications forget most of their Ends.
TEST_F(RefusedPrimitives, PrimitivesInPrimitivesAreOne) {
  const auto strips = [](bool nested) {
    glClear(GL_COLOR_BUFFER_BIT);
    for (int strip = 0; strip < 3; ++strip) {
      glLineWidth(float(1 + 2 * strip));
      glBegin(GL_LINE_STRIP);
      for (int i = 0; i < 50; ++i) {
        if (nested && i % 2 == 0) {
          glLineWidth(float(i));
          glBegin(GL_LINE_STRIP);
        }
        vertex(float(i) / 25 - 1, float((i + strip) % 3) / 3);
      }
      glEnd();
    }
    return readPicture(kSize);
  };
  const Picture wanted = strips(false);
  expectAlike(strips(true), wanted, "with Begins within");
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
}

/// The list contains the command, and the error is raised when the list is called.
TEST_F(RefusedPrimitives, AListKeepsThem) {
  const Picture wanted = drawn(nullptr);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBegin(GL_TRIANGLES);
  vertex(-0.9f, -0.9f), vertex(0.9f, -0.9f);
  glLineWidth(7);
  vertex(0.9f, 0.9f);
  glEnd();
  glEndList();
  while (glGetError() != GL_NO_ERROR)
    ;
  glCallList(list);
  const GLenum error = glGetError();
  EXPECT_EQ(error, GLenum(GL_INVALID_OPERATION));
  expectAlike(drawn(nullptr), wanted, "after the list");
  glDeleteLists(list, 1);
}

} // namespace
} // namespace api
