// Consecutive small draws that differ only in vertices, matrices and current values may be drawn as
// one: the picture is that of each drawn alone.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <vector>

#include "fixture.h"

namespace api {
namespace {

constexpr int kTarget = 48;

enum class Way { Immediate, Arrays, Elements, List };
struct Shape {
  GLenum mode = GL_TRIANGLES;
  Way way = Way::Immediate;
  std::vector<std::array<GLfloat, 3>> places;
  std::vector<std::array<GLfloat, 4>> colors; ///< empty: the current one
  std::vector<GLushort> order;                ///< for DrawElements
  GLuint list = 0;
};
/// A shape with a matrix and a color of its own.
struct Draw {
  std::size_t shape = 0;
  std::array<GLfloat, 3> at{};
  GLfloat turn = 0, size = 1;
  std::array<GLfloat, 4> color{};
};

class SmallDrawPrimitives : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    NEEDS("GL_EXT_framebuffer_object");
    glGenFramebuffersEXT(1, &m_framebuffer);
    glGenRenderbuffersEXT(2, m_buffers.data());
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, m_framebuffer);
    const std::array<std::pair<GLenum, GLenum>, 2> kinds = {
        {{GL_RGBA8, GL_COLOR_ATTACHMENT0_EXT}, {GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT_EXT}}};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      glBindRenderbufferEXT(GL_RENDERBUFFER_EXT, m_buffers[i]);
      glRenderbufferStorageEXT(GL_RENDERBUFFER_EXT, kinds[i].first, kTarget, kTarget);
      glFramebufferRenderbufferEXT(GL_FRAMEBUFFER_EXT, kinds[i].second, GL_RENDERBUFFER_EXT,
                                   m_buffers[i]);
    }
    glViewport(0, 0, kTarget, kTarget);
    std::array<GLubyte, 16> texels{};
    for (std::size_t i = 0; i < texels.size(); ++i)
      texels[i] = GLubyte(255 - 37 * i % 200);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    std::array<GLubyte, 128> stipple{};
    for (std::size_t i = 0; i < stipple.size(); ++i)
      stipple[i] = GLubyte(i / 4 % 2 ? 0x5A : 0xC3);
    glPolygonStipple(stipple.data());
  }
  void TearDown() override {
    for (const Shape &shape : m_shapes)
      if (shape.list != 0)
        glDeleteLists(shape.list, 1);
    glDeleteFramebuffersEXT(1, &m_framebuffer);
    glDeleteRenderbuffersEXT(2, m_buffers.data());
    ApiTest::TearDown();
  }

  void makeShapes(std::mt19937 &random);
  void draw(const Draw &draw) const;
  [[nodiscard]] Picture drawn(const std::vector<Draw> &draws, bool alone) const;

  GLuint m_framebuffer = 0;
  std::array<GLuint, 2> m_buffers{};
  std::vector<Shape> m_shapes;
};

void drawShape(const Shape &shape) {
  if (shape.way == Way::Immediate || shape.way == Way::List) {
    glBegin(shape.mode);
    for (std::size_t i = 0; i < shape.places.size(); ++i) {
      if (!shape.colors.empty())
        glColor4fv(shape.colors[i].data());
      glTexCoord2f(shape.places[i][0], shape.places[i][1]);
      glVertex3fv(shape.places[i].data());
    }
    return glEnd();
  }
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, shape.places.data());
  if (!shape.colors.empty()) {
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(4, GL_FLOAT, 0, shape.colors.data());
  }
  if (shape.way == Way::Arrays)
    glDrawArrays(shape.mode, 0, GLsizei(shape.places.size()));
  else
    glDrawElements(shape.mode, GLsizei(shape.order.size()), GL_UNSIGNED_SHORT, shape.order.data());
  glDisableClientState(GL_COLOR_ARRAY);
  glDisableClientState(GL_VERTEX_ARRAY);
}

void SmallDrawPrimitives::makeShapes(std::mt19937 &random) {
  std::uniform_real_distribution<float> place(-1, 1), unit(0.1f, 1);
  for (const Shape &shape : m_shapes)
    if (shape.list != 0)
      glDeleteLists(shape.list, 1);
  m_shapes.clear();
  for (int i = 0; i < 5; ++i) {
    Shape shape;
    shape.mode = GL_TRIANGLES + random() % 6;
    shape.way = Way(random() % 4);
    const bool isColored = random() % 2 == 0;
    for (unsigned count = 3 + random() % 10; count != 0; --count) {
      shape.places.push_back({place(random), place(random), 0.5f * place(random)});
      if (isColored)
        shape.colors.push_back({unit(random), unit(random), unit(random), unit(random)});
    }
    for (unsigned count = 3 + random() % 9; count != 0; --count)
      shape.order.push_back(GLushort(random() % shape.places.size()));
    if (shape.way == Way::List) {
      shape.list = glGenLists(1);
      glNewList(shape.list, GL_COMPILE);
      drawShape(shape);
      glEndList();
    }
    m_shapes.push_back(shape);
  }
}

void SmallDrawPrimitives::draw(const Draw &draw) const {
  const Shape &shape = m_shapes[draw.shape];
  glPushMatrix();
  glTranslatef(draw.at[0], draw.at[1], draw.at[2]);
  glRotatef(draw.turn, 0.2f, 0.3f, 1);
  glScalef(draw.size, draw.size, draw.size);
  glColor4fv(draw.color.data());
  glTexCoord2f(draw.at[1], 0.5f);
  if (shape.list != 0)
    glCallList(shape.list);
  else
    drawShape(shape);
  glPopMatrix();
}

Picture SmallDrawPrimitives::drawn(const std::vector<Draw> &draws, bool alone) const {
  std::array<GLubyte, 4> pixel{};
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const Draw &each : draws) {
    draw(each);
    if (alone)
      glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  }
  return readPicture(kTarget);
}

void chooseSmallDrawState(std::mt19937 &random) {
  const auto oneIn = [&](unsigned count) { return random() % count == 0; };
  const auto set = [](GLenum what, bool on) { on ? glEnable(what) : glDisable(what); };
  glShadeModel(oneIn(3) ? GL_FLAT : GL_SMOOTH);
  if (epoxy_has_gl_extension("GL_ARB_provoking_vertex"))
    glProvokingVertex(oneIn(3) ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
  const GLenum back = oneIn(6) ? GL_LINE : GL_FILL;
  glPolygonMode(GL_FRONT, GL_FILL);
  glPolygonMode(GL_BACK, back);
  glFrontFace(oneIn(2) ? GL_CW : GL_CCW);
  set(GL_CULL_FACE, oneIn(3));
  set(GL_POLYGON_STIPPLE, oneIn(6));
  set(GL_BLEND, oneIn(2));
  glBlendFunc(GL_SRC_ALPHA, GL_ONE);
  set(GL_POLYGON_OFFSET_FILL, oneIn(4));
  glPolygonOffset(1, 2);
  set(GL_DEPTH_TEST, oneIn(2));
  glDepthFunc(oneIn(2) ? GL_LESS : GL_LEQUAL);
  set(GL_TEXTURE_2D, oneIn(2));
  set(GL_SCISSOR_TEST, oneIn(4));
  glScissor(5, 7, 30, 36);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  if (oneIn(2)) {
    glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 8);
    glTranslatef(0, 0, -2.5f);
  }
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
}

TEST_F(SmallDrawPrimitives, LookAsEachDrawnAlone) {
  if (layered() && !rasterizerDrawsAll())
    GTEST_SKIP() << "the host may draw: one of the two pictures";
  std::size_t lit = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-1.2f, 1.2f), unit(0.1f, 1);
    chooseSmallDrawState(random);
    makeShapes(random);
    std::vector<Draw> draws(3 + random() % 30);
    // Sizes range from below a pixel to beyond the view; some are drawn again at their place.
    for (std::size_t i = 0; i < draws.size(); ++i) {
      if (i != 0 && random() % 5 == 0) {
        draws[i] = draws[i - 1];
        continue;
      }
      draws[i] = {random() % (1 + random() % m_shapes.size()),
                  {place(random), place(random), place(random)},
                  360 * unit(random),
                  random() % 4 == 0 ? 1.5f * unit(random) : 0.2f * unit(random),
                  {unit(random), unit(random), unit(random), unit(random)}};
    }
    const Picture alone = drawn(draws, true), together = drawn(draws, false);
    int differ = 0, most = 0;
    for (std::size_t i = 0; i < together.size(); ++i)
      if (alone[i] != together[i]) {
        ++differ;
        most = std::max(most, std::abs(alone[i] - together[i]));
      }
    EXPECT_EQ(differ, 0) << "of the bytes, by up to " << most << ", seed " << seed;
    for (std::size_t i = 0; i < together.size(); i += 4)
      lit += together[i] != 0 ? 1 : 0;
  }
  EXPECT_GT(lit, std::size_t(300) * kTarget * kTarget / 20);
}

TEST_F(SmallDrawPrimitives, AThousandBetweenOthersAreAllThere) {
  // There is one for each pixel, more than are joined at a time. Another kind of draw comes
  // between.
  const auto corner = [](int i) { return -1 + 2 * float(i) / float(kTarget); };
  glMatrixMode(GL_MODELVIEW);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBegin(GL_TRIANGLES);
  glVertex2f(0, 0), glVertex2f(2.0f / kTarget, 0), glVertex2f(0, 2.0f / kTarget);
  glVertex2f(2.0f / kTarget, 0), glVertex2f(2.0f / kTarget, 2.0f / kTarget),
      glVertex2f(0, 2.0f / kTarget);
  glEnd();
  glEndList();
  glClear(GL_COLOR_BUFFER_BIT);
  for (int y = 0; y < kTarget; ++y)
    for (int x = 0; x < kTarget; ++x) {
      glColor3ub(GLubyte(5 * x), GLubyte(5 * y), 255);
      glPushMatrix();
      glLoadIdentity();
      glTranslatef(corner(x), corner(y), 0);
      if ((x + y) % 500 == 11) {
        glBegin(GL_POINTS);
        glVertex2f(1.0f / kTarget, 1.0f / kTarget);
        glEnd();
      } else {
        glCallList(list);
      }
      glPopMatrix();
    }
  glDeleteLists(list, 1);
  const Picture picture = readPicture(kTarget);
  for (int i = 0; i < kTarget * kTarget; ++i) {
    const GLubyte *const pixel = &picture[std::size_t(4 * i)];
    ASSERT_NEAR(pixel[0], 5 * (i % kTarget), 1) << i;
    ASSERT_NEAR(pixel[1], 5 * (i / kTarget), 1) << i;
    ASSERT_EQ(pixel[2], 255) << i;
  }
}

} // namespace
} // namespace api
