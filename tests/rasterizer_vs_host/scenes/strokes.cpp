// Draws points, lines and unfilled polygons: rasterizer-strokes SEED COUNT. Each seed is a picture
// of each kind, with random sizes, widths, stipples and colors, smooth or not, inside the view or
// leaving it. Writes the pictures as records, which comparisons.py compares.
#include <array>
#include <string>

#include "picture.h"

namespace software {
namespace {

constexpr int kEdge = 160; ///< of the window, in pixels
constexpr int kPrimitives = 24;

constexpr Kind kKinds[] = {{"points", GL_POINTS, 8},         {"lines", GL_LINES, 8},
                           {"line strip", GL_LINE_STRIP, 5}, {"line loop", GL_LINE_LOOP, 4},
                           {"triangles", GL_TRIANGLES, 6},   {"quads", GL_QUADS, 4},
                           {"polygon", GL_POLYGON, 5}};

class Picture : PictureByChance {
public:
  explicit Picture(std::uint64_t seed) : PictureByChance(seed) {}

  void draw(const std::string &seed, const Kind &kind) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const bool isPolygon = kind.mode >= GL_TRIANGLES, isPoints = kind.mode == GL_POINTS;
    m_name = seed + " " + kind.name;
    const bool smooth = some("smooth");
    // If the ends of a line differ in w, hosts interpolate between dashes without w.
    const bool stippled = !isPoints && some("stippled"), perspective = !stippled && some("deep");
    const bool wide = some("wide"), leaving = some("leaving");
    set(GL_LINE_SMOOTH, smooth);
    set(GL_POINT_SMOOTH, smooth);
    set(GL_BLEND, smooth);
    set(GL_LINE_STIPPLE, stippled);
    glShadeModel(some("flat") ? GL_FLAT : GL_SMOOTH);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const std::array<GLfloat, 3> near = {1, 0, 0}, far = {1, 0.1f, 0.05f};
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION,
                       isPoints && some("attenuated") ? far.data() : near.data());
    for (int i = 0; i < kPrimitives; ++i) {
      glPolygonMode(GL_FRONT_AND_BACK, !isPolygon ? GL_FILL : i % 2 == 0 ? GL_LINE : GL_POINT);
      glLineStipple(m_random.between(1, 5), GLushort(m_random.below(1 << 16)));
      glLineWidth(wide ? real(0.5f, 7) : 1);
      glPointSize(wide ? real(0.5f, 20) : 1);
      primitive(kind, leaving ? 1.6f : 0.95f, perspective);
    }
    record(m_name, readRgba(0, 0, kEdge, kEdge));
  }

private:
  /// Emits a primitive whose first corner is in the view: if a strip's first line is outside, Mesa
  /// does not restart its stipple.
  void primitive(const Kind &kind, float reach, bool perspective) {
    glBegin(kind.mode);
    for (int i = 0; i < kind.corners; ++i) {
      const float w = perspective ? real(0.3f, 2) : 1, far = w * (i == 0 ? 0.9f : reach);
      glColor4f(real(0, 1), real(0, 1), real(0, 1), real(0.3f, 1));
      glVertex4f(real(-far, far), real(-far, far), w * real(-0.9f, 0.9f), w);
    }
    glEnd();
  }
};

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  const auto draw = [](int seed, auto &screen, GLXDrawable window, bool) {
    drawKinds(seed, screen, window, kEdge, kKinds,
              [seed](const std::string &name, const Kind &kind, std::size_t) {
                Picture(std::uint64_t(seed)).draw(name, kind);
              });
  };
  return drawSeeds(argc, argv, kEdge, nullptr, draw);
}
