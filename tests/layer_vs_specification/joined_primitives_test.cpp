// Consecutive strips, fans, loops and polygons may be drawn as one: the picture is that of each
// drawn alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

#include "fixture.h"

namespace api {
namespace {

struct Vertex {
  std::array<GLfloat, 4> position;
  std::array<GLfloat, 3> color;
};
using Primitive = std::vector<Vertex>;

/// Mesa 22.3.6 joins them too, but then continues a stipple from one strip to the next. If two
/// rasterizers draw, as under `auto` until code is compiled, lines are not equal.
#define HOST_DIFFERS()                                                                             \
  if (!rasterizerDrawsAll())                                                                       \
  GTEST_SKIP() << "the host may draw: stipples run on from one strip to the next"

class JoinedPrimitives : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    glViewport(0, 0, kSize, kSize);
    std::array<GLubyte, 128> stipple{};
    for (std::size_t i = 0; i < stipple.size(); ++i)
      stipple[i] = GLubyte(i / 4 % 2 ? 0x5A : 0xC3);
    glPolygonStipple(stipple.data());
  }

  static Picture drawn(const std::function<void()> &draw) {
    glClear(GL_COLOR_BUFFER_BIT);
    draw();
    return readPicture(kSize);
  }
  /// Compares random modes, states and primitives, which `draw` draws joined and alone.
  using Draw = void (*)(GLenum mode, const std::vector<Primitive> &primitives, bool alone);
  static void expectAlike(unsigned firstSeed, unsigned count, Draw draw);
  static std::size_t lit(const Picture &picture) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.size(); i += 4)
      count += picture[i] != 0 || picture[i + 1] != 0 || picture[i + 2] != 0 ? 1 : 0;
    return count;
  }
};

constexpr std::array<GLenum, 6> kModes = {GL_LINE_STRIP,   GL_LINE_LOOP,  GL_TRIANGLE_STRIP,
                                          GL_TRIANGLE_FAN, GL_QUAD_STRIP, GL_POLYGON};

/// Returns a primitive that may extend beyond the view. With `hasW` each vertex has its own w.
/// Without, inputs are affine; if only some primitives have one, those without are rounded
/// differently.
Primitive somePrimitive(std::mt19937 &random, bool hasW) {
  std::uniform_real_distribution<float> place(-1.3f, 1.3f), unit(0.1f, 1);
  Primitive primitive(1 + random() % 8);
  for (Vertex &vertex : primitive) {
    const float w = hasW ? 0.5f + unit(random) : 1;
    vertex.position = {place(random), place(random), place(random) * 0.8f, w};
    vertex.color = {unit(random), unit(random), unit(random)};
  }
  return primitive;
}

void draw(GLenum mode, const std::vector<Primitive> &primitives, bool alone) {
  for (const Primitive &primitive : primitives) {
    glBegin(mode);
    for (const Vertex &vertex : primitive) {
      glColor3fv(vertex.color.data());
      glVertex4fv(vertex.position.data());
    }
    glEnd();
    if (alone)
      (void)glGetError(); // any command that is not part of a primitive
  }
}

void chooseJoinedState(std::mt19937 &random) {
  const auto oneIn = [&](unsigned count) { return random() % count == 0; };
  const auto set = [](GLenum what, bool on) { on ? glEnable(what) : glDisable(what); };
  glShadeModel(oneIn(2) ? GL_FLAT : GL_SMOOTH);
  if (epoxy_has_gl_extension("GL_ARB_provoking_vertex"))
    glProvokingVertex(oneIn(3) ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
  const GLenum front = oneIn(6) ? GL_LINE : GL_FILL, back = oneIn(6) ? GL_POINT : GL_FILL;
  glPolygonMode(GL_FRONT, front);
  glPolygonMode(GL_BACK, back);
  glFrontFace(oneIn(2) ? GL_CW : GL_CCW);
  set(GL_CULL_FACE, oneIn(3));
  set(GL_LINE_STIPPLE, oneIn(3));
  glLineStipple(2, 0x33C5);
  set(GL_POLYGON_STIPPLE, oneIn(5));
  glLineWidth(oneIn(3) ? 3 : 1);
  // If some edges of polygons are smooth lines, the host draws, which may not join them.
  set(GL_LINE_SMOOTH, oneIn(4) && front == back);
  set(GL_BLEND, oneIn(2));
  glBlendFunc(GL_SRC_ALPHA, GL_ONE);
  set(GL_POLYGON_OFFSET_FILL, oneIn(4));
  glPolygonOffset(1, 2);
}

void JoinedPrimitives::expectAlike(unsigned firstSeed, unsigned count, Draw draw) {
  std::size_t all = 0;
  for (unsigned seed = firstSeed; seed < firstSeed + count; ++seed) {
    std::mt19937 random(seed);
    const GLenum mode = kModes[seed % kModes.size()];
    chooseJoinedState(random);
    std::vector<Primitive> primitives(2 + random() % 6);
    for (Primitive &primitive : primitives)
      primitive = somePrimitive(random, seed % 4 == 0);
    const Picture alone = drawn([&] { draw(mode, primitives, true); });
    const Picture joined = drawn([&] { draw(mode, primitives, false); });
    int differ = 0, most = 0;
    for (std::size_t i = 0; i < joined.size(); ++i) {
      differ += alone[i] != joined[i] ? 1 : 0;
      most = std::max(most, std::abs(alone[i] - joined[i]));
    }
    EXPECT_EQ(differ, 0) << "of the bytes, by up to " << most << ", seed " << seed;
    all += lit(joined);
  }
  EXPECT_GT(all, std::size_t(count) * kSize * kSize / 20);
}

TEST_F(JoinedPrimitives, LookAsEachDrawnAlone) {
  HOST_DIFFERS();
  expectAlike(0, 400, draw);
}

/// Calls lists of the primitives, one for all or one for each.
void drawListed(GLenum mode, const std::vector<Primitive> &primitives, bool alone) {
  const GLsizei count = alone ? GLsizei(primitives.size()) : 1;
  const GLuint lists = glGenLists(count);
  for (GLsizei i = 0; i < count; ++i) {
    glNewList(lists + GLuint(i), GL_COMPILE);
    draw(mode, alone ? std::vector<Primitive>{primitives[std::size_t(i)]} : primitives, false);
    glEndList();
  }
  for (GLsizei i = 0; i < count; ++i)
    glCallList(lists + GLuint(i));
  glDeleteLists(lists, count);
}

TEST_F(JoinedPrimitives, OfAListLookAsThoseOfTheirOwnLists) {
  HOST_DIFFERS();
  expectAlike(1000, 300, drawListed);
}

/// Draws a circle of that many sides around `x`, as a fan or a polygon.
void circle(GLenum mode, float x, int sides, float radius) {
  glBegin(mode);
  for (int i = 0; i < sides; ++i) {
    const float angle = 6.2831853f * float(i) / float(sides);
    glColor3f(float(i) / float(sides), 1, 0.5f);
    glVertex2f(x + radius * std::cos(angle), radius * std::sin(angle));
  }
  glEnd();
}

TEST_F(JoinedPrimitives, OneOfVeryManyVerticesFollowsSmallOnes) {
  for (const GLenum mode : {GL_TRIANGLE_FAN, GL_LINE_LOOP, GL_POLYGON})
    for (const int sides : {3000, 3100, 20'000, 300'000}) {
      const auto all = [&](bool alone) {
        for (const auto &[x, count] : {std::pair{-0.6f, 5}, {-0.2f, 7}, {0.4f, sides}, {0.1f, 6}}) {
          circle(mode, x, count, count > 100 ? 0.5f : 0.3f);
          if (alone)
            (void)glGetError();
        }
      };
      const Picture alone = drawn([&] { all(true); });
      const Picture joined = drawn([&] { all(false); });
      EXPECT_EQ(alone, joined) << "mode " << mode << ", " << sides << " sides";
      EXPECT_GT(lit(joined), 50u);
    }
}

TEST_F(JoinedPrimitives, AttributesOfTheFirstOneStayWithIt) {
  // The second primitive sets an attribute that the first did not, which keeps the earlier value.
  glColor3f(1, 0, 0);
  const Picture picture = drawn([] {
    for (const float left : {-1.0f, 0.0f}) {
      glBegin(GL_POLYGON);
      if (left == 0)
        glColor3f(0, 1, 0);
      glVertex2f(left, -1), glVertex2f(left + 1, -1), glVertex2f(left + 1, 1), glVertex2f(left, 1);
      glEnd();
    }
  });
  const auto at = [&](int x) { return &picture[std::size_t(4 * (kSize * kSize / 2 + x))]; };
  EXPECT_EQ(at(8)[0], 255);
  EXPECT_EQ(at(8)[1], 0);
  EXPECT_EQ(at(24)[0], 0);
  EXPECT_EQ(at(24)[1], 255);
  GLfloat color[4] = {};
  glGetFloatv(GL_CURRENT_COLOR, color);
  EXPECT_EQ(color[1], 1);
}

TEST_F(JoinedPrimitives, MaterialsAndMistakesWithin) {
  glEnable(GL_LIGHTING);
  const GLfloat red[] = {1, 0, 0, 1}, green[] = {0, 1, 0, 1}, none[] = {0, 0, 0, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, none);
  GLenum error = GL_NO_ERROR;
  const Picture picture = drawn([&] {
    for (int i = 0; i < 4; ++i) {
      const float left = -1 + 0.5f * float(i), right = left + 0.5f;
      glBegin(GL_TRIANGLE_FAN);
      glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, i % 2 ? red : green);
      glVertex2f(left, -1), glVertex2f(right, -1);
      if (i == 2)
        glEnable(GL_BLEND); // an error within the primitive
      glVertex2f(right, 1), glVertex2f(left, 1);
      glEnd();
    }
    error = glGetError();
  });
  EXPECT_EQ(error, GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(glIsEnabled(GL_BLEND), GL_FALSE);
  for (int i = 0; i < 4; ++i) {
    const GLubyte *const pixel = &picture[std::size_t(4 * (kSize * kSize / 2 + 4 + 8 * i))];
    EXPECT_EQ(pixel[0], i % 2 ? 255 : 0) << i;
    EXPECT_EQ(pixel[1], i % 2 ? 0 : 255) << i;
  }
}

/// Draws quads with materials at each vertex, as some programs set them. `again` sets all of them,
/// otherwise only those that change.
void drawQuads(std::mt19937 &random, bool again, bool follows) {
  std::array<GLfloat, 4> diffuse{}, given{-1, 0, 0, 0};
  for (int quad = 0; quad < 6; ++quad) {
    const float left = -1 + 0.3f * float(quad);
    glBegin(GL_QUADS);
    for (int vertex = 0; vertex < 4; ++vertex) {
      if (vertex == 0 || random() % 4 == 0) {
        diffuse = {float(random() % 8) / 7, float(random() % 8) / 7, 0.5f, 1};
      }
      const bool isNew = diffuse != given;
      if (again || isNew || follows)
        glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, diffuse.data());
      given = diffuse;
      if (random() % 5 == 0) { // by another command, and back
        glMaterialiv(GL_FRONT, GL_EMISSION, std::array<GLint, 4>{1 << 30, 0, 0, 0}.data());
        glMaterialf(GL_FRONT, GL_SHININESS, 128.5f); // an error
        glMaterialfv(GL_FRONT, GL_EMISSION, std::array<GLfloat, 4>{0, 0, 0.25f, 1}.data());
      }
      if (follows)
        glColor3f(0.25f * float(vertex), 1, float(random() % 2));
      glNormal3f(0, 0, 1);
      glVertex2f(left + (vertex == 1 || vertex == 2 ? 0.25f : 0), vertex < 2 ? -0.8f : 0.8f);
    }
    glEnd();
  }
}

TEST_F(JoinedPrimitives, MaterialsThatAreGivenAgainChangeNothing) {
  if (layered() && !rasterizerDrawsAll())
    GTEST_SKIP() << "the host may draw: one of the two pictures";
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  std::size_t all = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    (seed % 3 == 0 ? glEnable : glDisable)(GL_COLOR_MATERIAL);
    glMaterialfv(GL_FRONT, GL_EMISSION, std::array<GLfloat, 4>{0, 0, 0.25f, 1}.data());
    Picture picture[2];
    for (const bool again : {false, true}) {
      std::mt19937 random(seed);
      picture[again ? 1 : 0] = drawn([&] { drawQuads(random, again, seed % 3 == 0); });
      while (glGetError() != GL_NO_ERROR) {
      }
    }
    int most = 0; // the host computes products with lights, or they are computed for each vertex
    for (std::size_t i = 0; i < picture[0].size(); ++i)
      most = std::max(most, std::abs(picture[0][i] - picture[1][i]));
    ASSERT_LE(most, 1) << "seed " << seed;
    all += lit(picture[1]);
  }
  EXPECT_GT(all, std::size_t(60) * kSize * kSize / 3);
}

std::array<GLfloat, 4> materialNow(GLenum face, GLenum name) {
  std::array<GLfloat, 4> value{};
  glGetMaterialfv(face, name, value.data());
  return value;
}

TEST_F(JoinedPrimitives, MaterialsAreThoseOfTheLastVertex) {
  using Four = std::array<GLfloat, 4>;
  const Four red = {1, 0, 0, 1}, green = {0, 1, 0, 1}, blue = {0, 0, 1, 1}, none = {0, 0, 0, 1};
  for (const bool isLit : {true, false})
    for (const GLenum mode : {GL_QUADS, GL_TRIANGLE_FAN, GL_POLYGON}) {
      (isLit ? glEnable : glDisable)(GL_LIGHTING);
      glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, none.data());
      glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, blue.data());
      glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 3);
      glPushAttrib(GL_LIGHTING_BIT);
      GLenum error = GL_NO_ERROR;
      Four within = {8, 8, 8, 8};
      const Picture picture = drawn([&] {
        glBegin(mode);
        glColor3f(0, 0, 1);
        glVertex2f(-1, -1);
        glMaterialfv(GL_FRONT, GL_EMISSION, green.data());     // two corners are blue and two green
        glGetMaterialfv(GL_FRONT, GL_EMISSION, within.data()); // an error
        glColor3f(0, 1, 0);
        glVertex2f(1, -1), glVertex2f(1, 1);
        glMaterialfv(GL_FRONT, GL_EMISSION, blue.data());
        glColor3f(0, 0, 1);
        glVertex2f(-1, 1);
        glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, red.data()); // behind the last vertex
        glMaterialf(GL_BACK, GL_SHININESS, 5);
        glEnd();
        error = glGetError();
      });
      EXPECT_EQ(error, GLenum(GL_INVALID_OPERATION));
      EXPECT_EQ(within, (Four{8, 8, 8, 8}));
      for (const GLenum face : {GL_FRONT, GL_BACK}) {
        EXPECT_EQ(materialNow(face, GL_EMISSION), red);
        EXPECT_EQ(materialNow(face, GL_SHININESS)[0], face == GL_BACK ? 5 : 3);
      }
      glPopAttrib();
      for (const GLenum face : {GL_FRONT, GL_BACK}) {
        EXPECT_EQ(materialNow(face, GL_EMISSION), blue);
        EXPECT_EQ(materialNow(face, GL_SHININESS)[0], 3);
      }
      const auto at = [&](int x) { return &picture[std::size_t(4 * (kSize * kSize / 2 + x))]; };
      EXPECT_LT(at(1)[1], 20);
      EXPECT_GT(at(1)[2], 235);
      EXPECT_GT(at(kSize - 2)[1], 235);
      EXPECT_LT(at(kSize - 2)[2], 20);
    }
}

} // namespace
} // namespace api
