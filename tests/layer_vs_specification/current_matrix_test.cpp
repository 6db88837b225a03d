// Matrix commands change the matrix that MATRIX_MODE selects, in whatever way it was set. Draws use
// the matrices that GL queries return.
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "fixture.h"

namespace api {
namespace {

constexpr int kRow = 16;
using Matrix = std::array<GLfloat, 16>;

class CurrentMatrixPrimitives : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    if (!rasterizerDrawsAll())
      GTEST_SKIP() << "the host may draw: Mesa 22.3.6 draws with texture matrices of before";
    glViewport(0, 0, kRow, kRow);
    // Each texel contains its own position.
    std::array<GLubyte, 4 * 16> texels{};
    for (std::size_t i = 0; i < 16; ++i)
      texels[4 * i] = texels[4 * i + 1] = GLubyte(16 * i);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    m_lists = glGenLists(kLists);
    for (GLuint i = 0; i < kLists; ++i) {
      glNewList(m_lists + i, GL_COMPILE);
      if (i == 0)
        glMatrixMode(GL_PROJECTION);
      else if (i == 1)
        glMatrixMode(GL_MODELVIEW);
      else if (i == 2)
        glTranslatef(step(3), 0, 0);
      else
        glPushAttrib(GL_TRANSFORM_BIT), glMatrixMode(GL_TEXTURE), glLoadIdentity(), glPopAttrib();
      glEndList();
    }
  }
  void TearDown() override {
    if (m_lists != 0)
      glDeleteLists(m_lists, kLists);
    ApiTest::TearDown();
  }

  static constexpr GLuint kLists = 4;
  /// Returns a translation by pixels.
  static GLfloat step(int pixels) { return 2 * GLfloat(pixels) / kRow; }
  [[nodiscard]] std::string change(std::mt19937 &random) const;
  /// Draws a pixel at window coordinates (4, 8) if all matrices are the identity, and compares.
  static void expectPixel(const std::string &how);

  GLuint m_lists = 0;
};

std::string CurrentMatrixPrimitives::change(std::mt19937 &random) const {
  constexpr std::array<GLenum, 3> kModes = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};
  const int by = int(random() % 5) - 2;
  const GLenum mode = kModes[random() % 3];
  Matrix moved = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, step(by), 0, 0, 1};
  switch (random() % 14) {
  case 0:
  case 1:
    glMatrixMode(GL_MODELVIEW);
    return "MODELVIEW ";
  case 2:
    glMatrixMode(mode);
    return "mode ";
  case 3:
    glLoadMatrixf(moved.data());
    return "Load ";
  case 4:
  case 5:
    glTranslatef(step(by), 0, 0);
    return "Translate ";
  case 6:
    glPushMatrix();
    glLoadIdentity();
    return "Push ";
  case 7:
    glPopMatrix();
    (void)glGetError(); // there may be no error
    return "Pop ";
  case 8:
    glPushAttrib(GL_TRANSFORM_BIT);
    return "PushAttrib ";
  case 9:
    glPopAttrib();
    (void)glGetError();
    return "PopAttrib ";
  case 10:
  case 11: {
    const GLuint list = random() % kLists;
    glCallList(m_lists + list);
    return "list" + std::to_string(list) + " ";
  }
  case 12:
    glMatrixMode(GL_COLOR_MATERIAL); // an error
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    return "wrong ";
  default:
    if (!epoxy_has_gl_extension("GL_EXT_direct_state_access"))
      return "";
    glMatrixLoadfEXT(mode, moved.data());
    return "MatrixLoad ";
  }
}

void CurrentMatrixPrimitives::expectPixel(const std::string &how) {
  std::array<Matrix, 3> matrices{};
  glGetFloatv(GL_MODELVIEW_MATRIX, matrices[0].data());
  glGetFloatv(GL_PROJECTION_MATRIX, matrices[1].data());
  glGetFloatv(GL_TEXTURE_MATRIX, matrices[2].data());
  glClear(GL_COLOR_BUFFER_BIT);
  const GLfloat left = step(4) - 1, bottom = step(8) - 1;
  glBegin(GL_TRIANGLES);
  glTexCoord2f(0.53f, 0.5f);
  glVertex2f(left, bottom), glVertex2f(left + step(1), bottom), glVertex2f(left, bottom + step(1));
  glVertex2f(left + step(1), bottom), glVertex2f(left + step(1), bottom + step(1));
  glVertex2f(left, bottom + step(1));
  glEnd();
  std::array<GLubyte, 4 * kRow> row{};
  glReadPixels(0, 8, kRow, 1, GL_RGBA, GL_UNSIGNED_BYTE, row.data());
  const GLfloat moved = matrices[0][12] + matrices[1][12];
  const int place = 4 + int(std::lround(moved * kRow / 2));
  const int texel = int(std::floor(16 * (0.53f + matrices[2][12]))) & 15;
  for (int x = 0; x < kRow; ++x)
    ASSERT_EQ(row[std::size_t(4 * x)], x == place ? 16 * texel : 0)
        << "pixel " << x << ", texel " << texel << " at " << place << " after " << how;
}

TEST_F(CurrentMatrixPrimitives, DrawsAreUnderWhatWasChanged) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::string how = "seed " + std::to_string(seed) + ": ";
    for (const GLenum mode : {GL_PROJECTION, GL_TEXTURE, GL_MODELVIEW}) {
      glMatrixMode(mode);
      glLoadIdentity();
    }
    for (int i = 0; i < 40; ++i) {
      for (unsigned count = 1 + random() % 3; count != 0; --count)
        how += change(random);
      if (random() % 4 != 0) { // sometimes without a draw in between
        ASSERT_NO_FATAL_FAILURE(expectPixel(how));
      }
    }
    for (const GLenum mode : {GL_PROJECTION, GL_TEXTURE, GL_MODELVIEW}) {
      glMatrixMode(mode);
      while (glGetError() == GL_NO_ERROR)
        glPopMatrix();
    }
    do
      glPopAttrib();
    while (glGetError() == GL_NO_ERROR);
  }
}

} // namespace
} // namespace api
