// Draws of evaluators with NV_vertex_program's maps (5.1), beside the conventional ones.
#include <string>

#include "nv_commands.h"

namespace api::nv {
namespace {

constexpr GLenum kCurve = GL_MAP1_VERTEX_ATTRIB0_4_NV, kSurface = GL_MAP2_VERTEX_ATTRIB0_4_NV;

/// Defines a curve of the attribute, from one value to the other.
void line(GLuint attribute, const std::array<GLfloat, 4> &from, const std::array<GLfloat, 4> &to) {
  const GLfloat points[] = {from[0], from[1], from[2], from[3], to[0], to[1], to[2], to[3]};
  glMap1f(kCurve + attribute, 0, 1, 4, 2, points);
  glEnable(kCurve + attribute);
}

/// The corners of the whole window; u goes to the right and v up.
constexpr GLfloat kCorners[] = {-1, -1, 0, 1, -1, 1, 0, 1, 1, -1, 0, 1, 1, 1, 0, 1};
void surface(GLuint attribute, const GLfloat *corners) {
  glMap2f(kSurface + attribute, 0, 1, 8, 2, 0, 1, 4, 2, corners);
  glEnable(kSurface + attribute);
}
/// Defines a constant surface.
void flat(GLuint attribute, const std::array<GLfloat, 4> &value) {
  glMap2f(kSurface + attribute, 0, 1, 4, 1, 0, 1, 4, 1, value.data());
  glEnable(kSurface + attribute);
}

class NvEvaluatorTest : public NvTest {
protected:
  void TearDown() override {
    for (GLenum map = kCurve; LoadProgramNV && map < kCurve + 32; ++map)
      glDisable(map);
    NvTest::TearDown();
  }
  static void useAttribute(GLuint number) {
    use(kVertexNv, 60 + number,
        "!!VP1.0\nMOV o[HPOS], v[0];\nMOV o[COL0], v[" + std::to_string(number) + "];\nEND");
  }
};

void quadOfPoints() {
  glBegin(GL_QUADS);
  glEvalCoord2f(0, 0);
  glEvalCoord2f(1, 0);
  glEvalCoord2f(1, 1);
  glEvalCoord2f(0, 1);
  glEnd();
}

TEST_F(NvEvaluatorTest, EveryAttributeIsEvaluated) {
  surface(0, kCorners);
  for (GLuint i = 1; i < 16; ++i) {
    useAttribute(i);
    flat(i, {0, 1, 0, 1});
    VertexAttrib4fNV(i, 1, 0, 0, 1);
    clear();
    quadOfPoints();
    EXPECT_EQ(readPixel(), kGreenPixel) << i;
    GLfloat current[4] = {};
    GetVertexAttribfvNV(i, GL_CURRENT_ATTRIB_NV, current);
    EXPECT_EQ(current[0], 1) << "evaluation changes no current value: " << i;
    EXPECT_EQ(current[1], 0) << i;
    glDisable(kSurface + i);
    clear();
    quadOfPoints();
    EXPECT_EQ(readPixel(), kRedPixel) << "the current value, without its map: " << i;
  }
}

TEST_F(NvEvaluatorTest, AllFourComponentsAreEvaluated) {
  for (const GLuint i : {2u, 4u, 5u}) {
    use(kVertexNv, 60,
        "!!VP1.0\nMOV o[HPOS], v[0];\nMOV o[COL0], v[" + std::to_string(i) + "].wwww;\nEND");
    surface(0, kCorners);
    flat(i, {0.2f, 0.2f, 0.2f, 0.4f});
    clear();
    quadOfPoints();
    EXPECT_NEAR(readPixel()[0], 102, 1) << i;
    glDisable(kSurface + i);
  }
}

TEST_F(NvEvaluatorTest, ACurveGoesFromOneValueToTheOther) {
  useAttribute(3);
  line(0, {-1, 0.03f, 0, 1}, {1, 0.03f, 0, 1});
  line(3, {0, 0, 0, 1}, {1, 0, 1, 1});
  const auto check = [](const char *what) {
    for (const int x : {2, 16, 29}) {
      const Pixel pixel = readPixel(x, 16);
      EXPECT_NEAR(pixel[0], 255 * (x + 0.5) / 32, 3) << what << x;
      EXPECT_EQ(pixel[1], 0) << what << x;
    }
    clear();
  };
  clear();
  glBegin(GL_LINE_STRIP);
  for (int i = 0; i <= 8; ++i)
    glEvalCoord1d(i / 8.0);
  glEnd();
  check("coordinates ");
  glMapGrid1f(4, 0, 1);
  glBegin(GL_LINE_STRIP);
  for (int i = 0; i <= 4; ++i)
    glEvalPoint1(i);
  glEnd();
  check("points ");
  glEvalMesh1(GL_LINE, 0, 4);
  check("mesh ");
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glEvalMesh1(GL_LINE, 0, 4);
  glEndList();
  EXPECT_EQ(readPixel(16, 16), (Pixel{0, 0, 0, readPixel(16, 16)[3]})) << "compiled, not called";
  glCallList(list);
  check("mesh of a list ");
  glDeleteLists(list, 1);
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST_F(NvEvaluatorTest, MeshesOfEachMode) {
  useAttribute(3);
  surface(0, kCorners);
  flat(3, {0, 1, 0, 1});
  glMapGrid2f(2, 0, 1, 3, 0, 1);
  clear();
  glEvalMesh2(GL_FILL, 0, 2, 0, 3);
  EXPECT_EQ(readPixel(0, 0), kGreenPixel);
  EXPECT_EQ(readPixel(31, 31), kGreenPixel);
  clear();
  glEvalMesh2(GL_FILL, 0, 1, 0, 3); // the left half
  EXPECT_EQ(readPixel(4, 16), kGreenPixel);
  EXPECT_NE(readPixel(27, 16), kGreenPixel);
  clear();
  glEvalMesh2(GL_LINE, 1, 1, 0, 3); // the middle from top to bottom
  EXPECT_TRUE(readPixel(15, 8) == kGreenPixel || readPixel(16, 8) == kGreenPixel);
  EXPECT_NE(readPixel(4, 8), kGreenPixel);
  clear();
  glPointSize(6);
  glEvalMesh2(GL_POINT, 1, 1, 1, 1); // in the middle, at a third of the height
  glPointSize(1);
  EXPECT_EQ(readPixel(16, 11), kGreenPixel);
  EXPECT_NE(readPixel(16, 21), kGreenPixel);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glEvalMesh2(GL_QUADS, 0, 1, 0, 1));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glEvalMesh1(GL_FILL, 0, 1));
}

TEST_F(NvEvaluatorTest, ConventionalMapsAreEvaluatedBeside) {
  constexpr GLfloat kGreen[] = {0, 1, 0, 1};
  useAttribute(3);
  surface(0, kCorners);
  glMap2f(GL_MAP2_COLOR_4, 0, 1, 4, 1, 0, 1, 4, 1, kGreen);
  glEnable(GL_MAP2_COLOR_4);
  clear();
  quadOfPoints();
  EXPECT_EQ(readPixel(), kGreenPixel);
  flat(3, {1, 0, 0, 1});
  clear();
  quadOfPoints();
  EXPECT_EQ(readPixel(), kRedPixel) << "the program's map takes the place of the conventional one";
  glDisable(kSurface);
  clear();
  quadOfPoints();
  EXPECT_NE(readPixel(), kRedPixel) << "nothing happens without a map of the position";
  constexpr GLfloat kThree[] = {-1, -1, 0, -1, 1, 0, 1, -1, 0, 1, 1, 0};
  glMap2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, kThree);
  glEnable(GL_MAP2_VERTEX_3);
  clear();
  quadOfPoints();
  EXPECT_EQ(readPixel(), kRedPixel) << "the conventional position";
  glDisable(kVertexNv);
  clear();
  quadOfPoints();
  EXPECT_EQ(readPixel(), kGreenPixel) << "without a program its maps do not count";
  glDisable(GL_MAP2_VERTEX_3);
  glDisable(GL_MAP2_COLOR_4);
}

TEST_F(NvEvaluatorTest, TheNormalIsNotNormalised) {
  use(kVertexNv, 60, "!!VP1.0\nMOV o[HPOS], v[0];\nMOV o[COL0].xyz, v[2].zxww;\nEND");
  constexpr GLfloat kHalf[] = {-1, -1, 0, 2, -1, 1, 0, 2, 1, -1, 0, 2, 1, 1, 0, 2};
  glMap2f(kSurface, 0, 2, 8, 2, 0, 2.5f, 4, 2, kHalf); // q: 0.5 for each u, 0.4 for each v
  glEnable(kSurface);
  glEnable(GL_AUTO_NORMAL);
  flat(2, {1, 1, 1, 1}); // it overrides this map
  glPointSize(20);
  clear();
  glBegin(GL_POINTS);
  glEvalCoord2f(1, 1.25f);
  glEnd();
  glPointSize(1);
  EXPECT_NEAR(readPixel()[0], 51, 1) << "the length of (1,0,0)/2 x (0,0.4,0)";
  EXPECT_EQ(readPixel()[1], 0);
  EXPECT_EQ(readPixel()[2], 255) << "w is 1";
  glDisable(GL_AUTO_NORMAL);
}

TEST_F(NvEvaluatorTest, ListsDefineEnableAndEvaluate) {
  useAttribute(3);
  const GLuint lists = glGenLists(2);
  glNewList(lists, GL_COMPILE);
  surface(0, kCorners);
  flat(3, {0, 0, 1, 1});
  glEndList();
  EXPECT_FALSE(glIsEnabled(kSurface));
  glNewList(lists + 1, GL_COMPILE);
  quadOfPoints();
  glEndList();
  clear();
  glCallList(lists + 1);
  EXPECT_NE(readPixel(), kBluePixel);
  glCallList(lists);
  EXPECT_TRUE(glIsEnabled(kSurface));
  GLint order[2] = {};
  glGetMapiv(kSurface, GL_ORDER, order);
  EXPECT_EQ(order[0], 2);
  glCallList(lists + 1);
  EXPECT_EQ(readPixel(), kBluePixel);
  clear();
  quadOfPoints();
  EXPECT_EQ(readPixel(), kBluePixel);
  // The list is executed while it is compiled, and between the application's Begin and End.
  glNewList(lists + 1, GL_COMPILE_AND_EXECUTE);
  clear();
  quadOfPoints();
  glEndList();
  EXPECT_EQ(readPixel(), kBluePixel);
  glNewList(lists + 1, GL_COMPILE);
  glEvalCoord2f(1, 1);
  glEvalCoord2f(0, 1);
  glEndList();
  clear();
  glBegin(GL_QUADS);
  glEvalCoord2f(0, 0);
  glEvalCoord2f(1, 0);
  glCallList(lists + 1);
  glEnd();
  EXPECT_EQ(readPixel(), kBluePixel);
  glNewList(lists, GL_COMPILE);
  glMap1f(kCurve, 0, 0, 4, 2, kCorners);
  glEndList();
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glCallList(lists));
  glDeleteLists(lists, 2);
}

TEST_F(NvEvaluatorTest, AVertexBetweenPointsHasTheCurrentValues) {
  useAttribute(3);
  surface(0, kCorners);
  flat(3, {0, 1, 0, 1});
  glShadeModel(GL_FLAT); // by a triangle's last corner
  VertexAttrib4fNV(3, 1, 0, 0, 1);
  clear();
  glBegin(GL_TRIANGLE_STRIP);
  glEvalCoord2f(0, 0);
  glEvalCoord2f(1, 0);
  glVertex2f(-1, 1);
  glEvalCoord2f(1, 1);
  glEnd();
  glShadeModel(GL_SMOOTH);
  EXPECT_EQ(readPixel(8, 8), kRedPixel);
  EXPECT_EQ(readPixel(24, 24), kGreenPixel);
}

} // namespace
} // namespace api::nv
