// Draws slanting surfaces and lines: rasterizer-depth_planes SEED COUNT. Each seed draws primitives
// of each kind one after another, with random corners and transforms, in the window and in a
// framebuffer object. Each is drawn with and without polygon offset and with either provoking
// vertex; lines have random widths. Writes all 24 bits of the depths as records, which
// depth_planes.py compares.
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "surface.h"

namespace software {
namespace {

constexpr int kWidth = 101, kHeight = 67; // of both targets, in pixels

struct Kind {
  const char *name;
  GLenum mode;
  int corners;
  bool smooth = false;
};
constexpr Kind kKinds[] = {{"triangles", GL_TRIANGLES, 6},
                           {"strip", GL_TRIANGLE_STRIP, 6},
                           {"fan", GL_TRIANGLE_FAN, 6},
                           {"quads", GL_QUADS, 4},
                           {"quad strip", GL_QUAD_STRIP, 6},
                           {"polygon", GL_POLYGON, 5},
                           {"lines", GL_LINES, 12},
                           {"line strip", GL_LINE_STRIP, 5},
                           {"line loop", GL_LINE_LOOP, 4},
                           {"smooth lines", GL_LINES, 12, true},
                           {"smooth line loop", GL_LINE_LOOP, 5, true}};

class Scene {
public:
  Scene(std::uint64_t seed, bool cut) : m_random(seed), m_reach(cut ? 2.5f : 1.0f) {}

  /// Draws only smooth ones, or only the others.
  void draw(const std::string &name, bool smooth) {
    glViewport(0, 0, kWidth, kHeight);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    (smooth ? glEnable : glDisable)(GL_LINE_SMOOTH);
    for (const Kind &kind : kKinds) {
      if (kind.smooth != smooth)
        continue;
      const bool isFirst = m_random.once(2);
      glProvokingVertex(isFirst ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
      const bool raised = !smooth && m_random.once(3);
      (raised ? glEnable : glDisable)(GL_POLYGON_OFFSET_FILL);
      glPolygonOffset(real(-2, 2), real(-3000, 3000));
      const char *const way = transform();
      if (isLines(kind))
        glLineWidth(m_random.once(2) ? 1 : real(1, 5));
      const bool arrays = m_random.once(2);
      primitive(kind, arrays);
      record(name + " " + kind.name + " " + way + (raised ? " offset" : "") +
                 (arrays ? " arrays" : "") + (isFirst ? " first" : ""),
             depths());
    }
    record(name + " errors" + takeErrors(), {});
  }

private:
  static bool isLines(const Kind &kind) {
    return kind.mode >= GL_LINES && kind.mode <= GL_LINE_STRIP;
  }
  float real(float low, float high) { return m_random.real(low, high); }

  const char *transform() {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    m_size = m_reach;
    const int way = m_random.below(3);
    if (way == 0)
      return "untransformed";
    m_size = 4 * m_reach;
    glMatrixMode(GL_PROJECTION);
    if (way == 1)
      glFrustum(-1, 1, -0.7, 0.7, 1, 30);
    else
      glOrtho(-10, 10, -7, 7, -10, 30);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -8);
    glRotatef(real(0, 360), real(-1, 1), real(-1, 1), 1);
    return way == 1 ? "perspective" : "parallel";
  }

  void primitive(const Kind &kind, bool arrays) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    std::vector<std::array<float, 3>> corners(std::size_t(kind.corners));
    for (std::array<float, 3> &corner : corners)
      for (float &value : corner)
        value = real(-m_size, m_size);
    if (kind.mode == GL_QUADS || kind.mode == GL_POLYGON)
      flatten(corners);
    if (arrays) {
      glEnableClientState(GL_VERTEX_ARRAY);
      glVertexPointer(3, GL_FLOAT, 0, corners.data());
      glDrawArrays(kind.mode, 0, kind.corners);
      glDisableClientState(GL_VERTEX_ARRAY);
      return;
    }
    glBegin(kind.mode);
    for (const std::array<float, 3> &corner : corners)
      glVertex3fv(corner.data());
    glEnd();
  }

  /// Makes corners convex and coplanar, as quads and polygons must be.
  void flatten(std::vector<std::array<float, 3>> &corners) {
    const float slopeX = real(-0.5f, 0.5f), slopeY = real(-0.5f, 0.5f);
    constexpr float kX[] = {-1, 0.3f, 1, 0.6f, -0.7f}, kY[] = {-0.6f, -1, 0.1f, 1, 0.5f};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const float x = m_size * kX[i] * real(0.7f, 1), y = m_size * kY[i] * real(0.7f, 1);
      corners[i] = {x, y, slopeX * x + slopeY * y};
    }
  }

  static std::vector<unsigned char> depths() {
    std::vector<unsigned char> bytes(std::size_t(kWidth) * kHeight * 4);
    glReadPixels(0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, bytes.data());
    return bytes;
  }

  Random m_random;
  float m_reach, m_size = 1;
};

/// Selects the window, or a framebuffer object with 24 bits of depth and 8 of stencil like it.
void useTarget(const std::string &name) {
  static GLuint s_framebuffer = 0;
  if (name == "window")
    return glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (s_framebuffer != 0)
    return glBindFramebuffer(GL_FRAMEBUFFER, s_framebuffer);
  s_framebuffer = makeFramebuffer();
  attachBuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, kWidth, kHeight);
  attachBuffer(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, kWidth, kHeight);
}

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  if (argc != 3)
    return 2;
  software::Screen screen; // X11 has a Screen too
  if (!screen.open())
    return 1;
  screen.makeCurrent(screen.makeWindow(kWidth, kHeight), screen.makeContext());
  const int first = std::atoi(argv[1]), count = std::atoi(argv[2]);
  // Mesa 22.3.6 changes polygon offsets once a context has drawn smooth lines, and raises errors
  // for them.
  for (const bool smooth : {false, true})
    for (const char *const target : {"window", "object"}) {
      useTarget(target);
      for (int seed = first; seed < first + count; ++seed)
        for (const bool cut : {false, true})
          Scene(std::uint64_t(2 * seed + cut), cut)
              .draw(std::string(target) + (cut ? " cut" : "") + " seed " + std::to_string(seed),
                    smooth);
    }
  return 0;
}
