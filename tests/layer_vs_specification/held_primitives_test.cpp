// Consecutive primitives of Begin and End may be drawn as one. Commands between them must take
// effect in between, and queries must be answered as if each was drawn.
#include <array>

#include "fixture.h"

namespace api {
namespace {

using Texel = std::array<GLubyte, 4>;
constexpr Texel kRedTexel = {255, 0, 0, 255}, kGreenTexel = {0, 255, 0, 255},
                kBlackTexel = {0, 0, 0, 0};

class HeldPrimitives : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    glViewport(0, 0, 32, 32);
    glClear(GL_COLOR_BUFFER_BIT);
  }

  /// Draws column `i` of four with the current state.
  static void column(int i, GLenum mode = GL_QUADS) {
    const float left = -1 + float(i) * 0.5f, right = left + 0.5f;
    glBegin(mode);
    glVertex2f(left, -1), glVertex2f(right, -1);
    glVertex2f(right, 1), glVertex2f(left, 1);
    glEnd();
  }
  static Texel at(int i) {
    Texel pixel{};
    glReadPixels(4 + 8 * i, 16, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    return pixel;
  }
};

TEST_F(HeldPrimitives, AttributesBetweenThem) {
  glColor3f(1, 0, 0);
  column(0);
  glColor3f(0, 1, 0);
  column(1);
  glColor4ub(255, 0, 0, 255);
  column(2);
  column(3);
  EXPECT_EQ(at(0), kRedTexel);
  EXPECT_EQ(at(1), kGreenTexel);
  EXPECT_EQ(at(2), kRedTexel);
  EXPECT_EQ(at(3), kRedTexel);
}

TEST_F(HeldPrimitives, CurrentValuesAreThoseOfTheLast) {
  glEnable(GL_COLOR_MATERIAL);
  glColor3f(1, 0, 0);
  column(0);
  glColor3f(0.25f, 0.5f, 1);
  GLfloat value[4] = {};
  glGetMaterialfv(GL_FRONT, GL_DIFFUSE, value);
  EXPECT_EQ(value[0], 0.25f);
  EXPECT_EQ(value[1], 0.5f);
  column(1);
  glVertexAttrib4f(5, 1, 2, 3, 4);
  glGetVertexAttribfv(5, GL_CURRENT_VERTEX_ATTRIB, value);
  EXPECT_EQ(value[3], 4);
  column(1);
  glColor3f(0, 1, 0);
  glGetFloatv(GL_CURRENT_COLOR, value);
  EXPECT_EQ(value[1], 1);
  EXPECT_EQ(at(0), kRedTexel);
}

TEST_F(HeldPrimitives, StateBetweenThem) {
  glColor3f(1, 0, 0);
  column(0);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  column(1);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glTranslatef(0.5f, 0, 0);
  column(1);
  glLoadIdentity();
  column(3);
  glScissor(0, 0, 32, 8);
  glEnable(GL_SCISSOR_TEST);
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(at(0), kRedTexel);
  EXPECT_EQ(at(1), kBlackTexel);
  EXPECT_EQ(at(2), kRedTexel);
  EXPECT_EQ(at(3), kRedTexel);
}

TEST_F(HeldPrimitives, ProgramsAndTheirParameters) {
  makeProgram("!!ARBfp1.0\nMOV result.color, program.local[0];\nEND");
  glEnable(kFragment);
  glProgramLocalParameter4fARB(kFragment, 0, 1, 0, 0, 1);
  column(0);
  glProgramLocalParameter4fARB(kFragment, 0, 0, 1, 0, 1);
  column(1);
  const GLuint other = makeProgram("!!ARBfp1.0\nMOV result.color, {1, 0, 0, 1};\nEND");
  column(2);
  glDisable(kFragment);
  glColor3f(0, 1, 0);
  column(3);
  glDeleteProgramsARB(1, &other);
  EXPECT_EQ(at(0), kRedTexel);
  EXPECT_EQ(at(1), kGreenTexel);
  EXPECT_EQ(at(2), kRedTexel);
  EXPECT_EQ(at(3), kGreenTexel);
}

TEST_F(HeldPrimitives, ImagesBetweenThem) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  const auto fill = [](const Texel &texel) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
  };
  fill(kRedTexel);
  column(0);
  fill(kGreenTexel);
  column(1);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 16, 1, 1); // the first column
  column(2);
  glDeleteTextures(1, &texture);
  EXPECT_EQ(at(0), kRedTexel);
  EXPECT_EQ(at(1), kGreenTexel);
  EXPECT_EQ(at(2), kRedTexel);
}

TEST_F(HeldPrimitives, OtherModesArraysAndLists) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glColor3f(0, 1, 0);
  column(1);
  glEndList();
  glColor3f(1, 0, 0);
  column(0);
  column(1, GL_POLYGON);
  glCallList(list);
  column(2);
  const GLfloat corners[] = {0.5f, -1, 1, -1, 1, 1, 0.5f, 1};
  glVertexPointer(2, GL_FLOAT, 0, corners);
  glEnableClientState(GL_VERTEX_ARRAY);
  column(3);
  glColor3f(1, 0, 0);
  glDrawArrays(GL_QUADS, 0, 4);
  EXPECT_EQ(at(0), kRedTexel);
  EXPECT_EQ(at(1), kGreenTexel);
  EXPECT_EQ(at(2), kGreenTexel);
  EXPECT_EQ(at(3), kRedTexel);
  glDeleteLists(list, 1);
}

TEST_F(HeldPrimitives, WholeOnesFollowOnesThatAreNot) {
  glColor3f(1, 0, 0);
  column(0);
  glBegin(GL_QUADS); // three vertices draw nothing, and change no other quad
  glVertex2f(-1, -1), glVertex2f(1, -1), glVertex2f(1, 1);
  glEnd();
  column(1);
  glBegin(GL_QUADS);
  glEnd();
  column(2);
  EXPECT_EQ(at(0), kRedTexel);
  EXPECT_EQ(at(1), kRedTexel);
  EXPECT_EQ(at(2), kRedTexel);
  EXPECT_EQ(at(3), kBlackTexel);
}

TEST_F(HeldPrimitives, QueriesCountWhatIsBetweenTheirCommands) {
  GLuint query = 0;
  glGenQueries(1, &query);
  glColor3f(1, 0, 0);
  column(0);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  column(1);
  column(2);
  glEndQuery(GL_SAMPLES_PASSED);
  column(3);
  GLuint samples = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  EXPECT_EQ(samples, 512u);
  glDeleteQueries(1, &query);
}

TEST_F(HeldPrimitives, MistakesBetweenThem) {
  glColor3f(1, 0, 0);
  column(0);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glEnd());
  column(1);
  glVertex2f(0.9f, 0.9f); // no effect outside of a primitive
  column(2);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glBegin(0x1234));
  EXPECT_EQ(at(0), kRedTexel);
  EXPECT_EQ(at(1), kRedTexel);
  EXPECT_EQ(at(2), kRedTexel);
  EXPECT_EQ(at(3), kBlackTexel);
  glBegin(GL_QUADS);
  GLdouble plane[4] = {};
  GLfloat values[4] = {};
  glGetClipPlane(GL_CLIP_PLANE0, plane);
  glGetLightfv(GL_LIGHT0, GL_AMBIENT, values);
  glGetMaterialfv(GL_FRONT, GL_AMBIENT, values);
  glGetTexGenfv(GL_S, GL_OBJECT_PLANE, values);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
}

TEST_F(HeldPrimitives, AnotherContextSeesThemAfterFinish) {
  GLuint texture = 0, framebuffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  const GlContext other(&m_context);
  m_context.makeCurrent();
  glColor3f(0, 1, 0);
  for (int i = 0; i < 4; ++i)
    column(i);
  other.makeCurrent(); // finishes the first context's drawing
  std::array<Texel, 32 * 32> texels{};
  glBindTexture(GL_TEXTURE_2D, texture);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  EXPECT_EQ(texels[0], kGreenTexel);
  EXPECT_EQ(texels[1023], kGreenTexel);
  m_context.makeCurrent();
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteTextures(1, &texture);
}

} // namespace
} // namespace api
