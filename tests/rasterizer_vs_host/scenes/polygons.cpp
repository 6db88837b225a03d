// Draws filled polygons of any shape: rasterizer-polygons SEED COUNT. Each seed is a picture of
// each kind, including quads that are not flat or cross themselves. They vary in provoking vertex,
// colors, fog, two-sided light, culling, stipple and clipping, and come from Begin and End, arrays,
// elements and lists. Overlaps show which half of a quad is drawn first, colors and fog how it is
// split. Writes the pictures as records, which comparisons.py compares.
#include <array>
#include <string>

#include "picture.h"

namespace software {
namespace {

constexpr int kEdge = 160; ///< of the window, in pixels
constexpr int kPrimitives = 16;

constexpr Kind kKinds[] = {{"triangles", GL_TRIANGLES, 6},   {"strip", GL_TRIANGLE_STRIP, 6},
                           {"fan", GL_TRIANGLE_FAN, 6},      {"quads", GL_QUADS, 8},
                           {"quad strip", GL_QUAD_STRIP, 8}, {"polygon", GL_POLYGON, 5}};

constexpr std::size_t kMaxCorners = 8;
constexpr const char *kWays[] = {"by Begin", "by arrays", "by elements"};

class Picture : PictureByChance {
public:
  explicit Picture(std::uint64_t seed) : PictureByChance(seed) {}

  /// Draws quads in fog in all ways, with the state that decides how they are split.
  void drawWays(const std::string &seed, const Kind &kind) {
    for (const GLenum shade : {GL_FLAT, GL_SMOOTH})
      for (const GLenum provoking : {GL_FIRST_VERTEX_CONVENTION, GL_LAST_VERTEX_CONVENTION})
        for (const char *const way : kWays)
          for (const bool oneColor : {false, true}) {
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            glShadeModel(shade);
            glProvokingVertex(provoking);
            fog(true);
            m_way = way;
            m_oneColor = oneColor;
            for (int i = 0; i < kPrimitives; ++i) {
              glFlush(); // Mesa applies a color to waiting vertices before it
              primitive(kind, 0.95f);
            }
            record(seed + " " + kind.name + (shade == GL_FLAT ? " flat" : "") +
                       (provoking == GL_FIRST_VERTEX_CONVENTION ? " first " : " ") + way +
                       (oneColor ? " of one colour" : ""),
                   readRgba(0, 0, kEdge, kEdge));
          }
  }

  void draw(const std::string &seed, const Kind &kind) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    m_name = seed + " " + kind.name;
    glShadeModel(some("flat") ? GL_FLAT : GL_SMOOTH);
    glProvokingVertex(some("first") ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
    light(some("lit"));
    set(GL_CULL_FACE, some("culled"));
    glCullFace(m_random.once(2) ? GL_FRONT : GL_BACK);
    set(GL_POLYGON_STIPPLE, some("stippled"));
    std::array<GLubyte, 128> pattern{};
    for (GLubyte &byte : pattern)
      byte = GLubyte(m_random.below(256));
    glPolygonStipple(pattern.data());
    cut(some("cut"));
    fog(some("fogged"));
    m_way = m_random.pick(kWays);
    m_name += std::string(" ") + m_way;
    m_oneColor = some("of one colour");
    const float reach = some("leaving") ? 1.7f : 0.95f;
    const bool listed = some("listed");
    for (int i = 0; i < kPrimitives; ++i) {
      if (listed)
        glNewList(1, GL_COMPILE);
      primitive(kind, reach);
      if (listed) {
        glEndList();
        glCallList(1);
      }
    }
    record(m_name, readRgba(0, 0, kEdge, kEdge));
  }

private:
  /// Lights front faces in the vertices' colors, back faces in one.
  static void light(bool on) {
    constexpr GLfloat kBlack[] = {0, 0, 0, 1}, kBlue[] = {0, 0.3f, 1, 1};
    set(GL_LIGHTING, on);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, kBlack);
    glDisable(GL_COLOR_MATERIAL);
    glMaterialfv(GL_BACK, GL_EMISSION, kBlue);
    glColorMaterial(GL_FRONT, GL_EMISSION);
    set(GL_COLOR_MATERIAL, on);
  }

  static void fog(bool on) {
    constexpr GLfloat kBlue[] = {0, 0.2f, 1, 1};
    set(GL_FOG, on);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, -1);
    glFogf(GL_FOG_END, 1);
    glFogfv(GL_FOG_COLOR, kBlue);
  }

  void cut(bool on) {
    for (GLenum plane = GL_CLIP_PLANE0; plane < GL_CLIP_PLANE0 + 2; ++plane) {
      const std::array<GLdouble, 4> equation = {double(real(-1, 1)), double(real(-1, 1)),
                                                double(real(-1, 1)), double(real(0, 0.8f))};
      glClipPlane(plane, equation.data());
      set(plane, on);
    }
  }

  void primitive(const Kind &kind, float reach) {
    const float x = real(-0.6f, 0.6f), y = real(-0.6f, 0.6f), size = real(0.1f, 1);
    const auto at = [&](float middle) { return reach * (middle + size * real(-0.4f, 0.4f)); };
    std::array<std::array<float, 4>, kMaxCorners> colors;
    std::array<std::array<float, 3>, kMaxCorners> places;
    for (auto &color : colors)
      color = {real(0.1f, 1), real(0.1f, 1), 0, 1};
    for (auto &place : places)
      place = {at(x), at(y), reach * real(-0.9f, 0.9f)};
    if (m_oneColor)
      glColor4fv(colors[0].data());
    if (m_way == kWays[0]) {
      glBegin(kind.mode);
      for (std::size_t i = 0; i < std::size_t(kind.corners); ++i) {
        if (!m_oneColor)
          glColor4fv(colors[i].data());
        glVertex3fv(places[i].data());
      }
      glEnd();
      return;
    }
    glVertexPointer(3, GL_FLOAT, 0, places.data());
    glColorPointer(4, GL_FLOAT, 0, colors.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    if (!m_oneColor)
      glEnableClientState(GL_COLOR_ARRAY);
    constexpr GLubyte kIndices[kMaxCorners] = {0, 1, 2, 3, 4, 5, 6, 7};
    if (m_way == kWays[1])
      glDrawArrays(kind.mode, 0, kind.corners);
    else
      glDrawElements(kind.mode, kind.corners, GL_UNSIGNED_BYTE, kIndices);
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
  }

  const char *m_way = nullptr; ///< one of kWays
  bool m_oneColor = false;
};

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  const auto draw = [](int seed, auto &screen, GLXDrawable window, bool) {
    drawKinds(seed, screen, window, kEdge, kKinds,
              [seed](const std::string &name, const Kind &kind, std::size_t index) {
                glEnable(GL_DEPTH_TEST);
                glDepthFunc(GL_ALWAYS);
                Picture picture(std::uint64_t(seed) * std::size(kKinds) + index);
                if (index == 0 && seed % 4 == 0) // before any state is set
                  picture.drawWays(name, kKinds[3]);
                picture.draw(name, kind);
              });
  };
  return drawSeeds(argc, argv, kEdge, nullptr, draw);
}
