// Draws lit primitives whose materials are set between Begin and End (OpenGL 2.1, 2.14.2):
// rasterizer-materials SEED COUNT. Each seed is a few draws of several primitives each, with its
// own lights. Materials change randomly at any vertex, on one side or both. Writes pictures and the
// final materials as records, which comparisons.py compares.
#include <array>
#include <string>

#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 64; // of the window, in pixels
constexpr int kDraws = 10;
constexpr GLenum kParts[] = {GL_EMISSION, GL_AMBIENT,   GL_DIFFUSE,
                             GL_SPECULAR, GL_SHININESS, GL_AMBIENT_AND_DIFFUSE};

class Draws {
public:
  Draws(std::uint64_t seed, Screen &screen, GLXDrawable window, bool cut)
      : m_random(seed), m_screen(screen), m_window(window), m_context(screen.makeContext()),
        m_cut(cut) {
    screen.makeCurrent(window, m_context);
    glViewport(0, 0, kEdge, kEdge);
    glDisable(GL_DITHER);
    glClearColor(0.25f, 0.5f, 0.125f, 0.5f);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, kEdge, 0, kEdge, -64, 64);
    glMatrixMode(GL_MODELVIEW);
  }
  ~Draws() { m_screen.destroy(m_context); }
  Draws(const Draws &) = delete;
  Draws &operator=(const Draws &) = delete;

  void run(const std::string &name) {
    for (int draw = 0; draw < kDraws; ++draw) {
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      glPushAttrib(GL_ALL_ATTRIB_BITS);
      lighting();
      pixels();
      primitives();
      const std::string what = name + ", draw " + std::to_string(draw) + state();
      record(what + materials(), {});
      glPopAttrib();
      record(what, readRgba(0, 0, kEdge, kEdge));
      m_screen.swap(m_window);
    }
    record(name + " errors" + takeErrors(), {});
  }

private:
  using Four = std::array<float, 4>;
  /// Returns a multiple of 1/8.
  [[nodiscard]] float part(int low = 0, int high = 8) {
    return float(m_random.between(low, high)) / 8;
  }
  [[nodiscard]] bool once(int of) { return m_random.once(of); }
  void set(GLenum capability, bool on) { (on ? glEnable : glDisable)(capability); }
  /// Returns one of few colors, so that some are set again.
  Four color() { return {part(0, 2), part(0, 2), part(0, 2), part(4, 6)}; }
  Four around() { return {part(-8), part(-8), part(-8), part(-8)}; }

  void lighting() {
    set(GL_LIGHTING, !once(5));
    set(GL_COLOR_MATERIAL, once(3));
    set(GL_NORMALIZE, once(2));
    m_isTwoSided = once(2);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, m_isTwoSided ? 1 : 0);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, m_random.below(2));
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                  once(2) ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, color().data());
    for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 4; ++light) {
      set(light, once(2));
      glLightfv(light, GL_AMBIENT, color().data());
      glLightfv(light, GL_DIFFUSE, around().data());
      glLightfv(light, GL_SPECULAR, color().data());
      const Four position = {float(m_random.between(-40, 90)), float(m_random.between(-40, 90)),
                             float(m_random.between(8, 60)), float(m_random.below(2))};
      glLightfv(light, GL_POSITION, position.data());
      glLightfv(light, GL_SPOT_DIRECTION, Four{part(-8), part(-8), -1, 0}.data());
      // The cones are wide, as at the edge of a cone the last bit decides.
      glLightf(light, GL_SPOT_CUTOFF, once(3) ? 90.0f : 180.0f);
      glLightf(light, GL_SPOT_EXPONENT, float(m_random.below(6)));
      glLightf(light, GL_CONSTANT_ATTENUATION, 0.5f + part());
      glLightf(light, GL_LINEAR_ATTENUATION, once(2) ? 0 : part() / 32);
    }
    for (const GLenum face : {GL_FRONT, GL_BACK})
      for (const GLenum name : kParts)
        give(face, name);
    // BACK alone is not used: Mesa 22.3.6 then has green and blue of 1, for any materials.
    constexpr GLenum kFaces[] = {GL_FRONT, GL_FRONT_AND_BACK};
    constexpr GLenum kTracked[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION,
                                   GL_AMBIENT_AND_DIFFUSE};
    const GLenum face = m_random.pick(kFaces);
    glColorMaterial(face, m_random.pick(kTracked));
  }

  void pixels() {
    glShadeModel(once(4) ? GL_FLAT : GL_SMOOTH);
    set(GL_BLEND, once(4));
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    set(GL_DEPTH_TEST, once(2)); // draws that must meet depths wait for code
    glDepthFunc(GL_ALWAYS);
    set(GL_POLYGON_OFFSET_FILL, once(2));
    glPolygonOffset(1, 1);
    set(GL_CULL_FACE, once(8));
    glFrontFace(once(2) ? GL_CW : GL_CCW);
    glPointSize(float(m_random.between(1, 12)));
    glLineWidth(float(m_random.between(1, 4)));
    m_rarely = once(8) ? 0 : m_random.between(2, 4);
    m_sides = m_random.below(3);
    m_isAhead = once(3);
    m_grows = !m_isAhead && once(3);
  }

  void give(GLenum face, GLenum name) {
    if (name == GL_SHININESS) // never 0: Mesa 22.3.6 attenuates such a highlight too much
      return glMaterialf(face, name, float(m_random.between(1, 12)));
    glMaterialfv(face, name, color().data());
  }

  void material() {
    constexpr GLenum kFaces[] = {GL_FRONT, GL_FRONT_AND_BACK, GL_BACK};
    const GLenum face = m_sides == 0 ? GL_FRONT_AND_BACK : m_random.pick(kFaces);
    const GLenum name = m_random.pick(kParts);
    const bool isOdd = !m_isTwoSided && once(20); // the host may have to draw it
    if (isOdd && once(3)) {
      const GLint values[4] = {1 << 30, 0, 1 << 29, 1 << 30};
      return glMaterialiv(face, GL_DIFFUSE, values);
    }
    if (isOdd && once(2))
      return glMaterialf(face, GL_SHININESS, once(2) ? 128.5f : -1.0f); // errors
    if (isOdd)
      return glMaterialfv(once(2) ? GL_LEFT : face, once(2) ? GL_FOG : GL_DIFFUSE, color().data());
    give(face, name);
  }

  /// Sets a material between Begin and End.
  void materialWithin() {
    const bool cut = m_cut && m_mode == GL_POINTS;
    if (cut)
      glEnd();
    material();
    if (cut)
      glBegin(m_mode);
  }

  void vertex(float x, float y) {
    while (!m_isAhead && m_rarely != 0 && once(m_rarely))
      materialWithin();
    if (once(2))
      glColor4fv(color().data());
    glNormal3f(part(-8), part(-8), once(4) ? -1.0f : 1.0f);
    if (!m_isTwoSided && once(80)) { // an error between Begin and End without effect
      float value[4] = {};
      glGetMaterialfv(GL_FRONT, GL_DIFFUSE, value);
    }
    glVertex3f(x, y, part(-8));
  }

  /// Sets what a primitive has from its first vertex on. Mesa 22.3.6 draws some primitives wrong
  /// that get a part only later.
  void ahead() {
    glColor4fv(color().data());
    if (m_grows)
      return;
    for (const GLenum face : {GL_FRONT, GL_BACK})
      for (const GLenum name : kParts)
        give(face, name);
    while (m_isAhead && m_rarely != 0 && once(m_rarely))
      material();
  }

  void primitive(GLenum mode) {
    const int left = m_random.below(40), bottom = m_random.below(40);
    const int wide = m_random.between(8, 24), high = m_random.between(8, 24);
    const bool strip = mode == GL_TRIANGLE_STRIP || mode == GL_QUAD_STRIP;
    if (m_cut)
      ahead();
    glBegin(mode);
    if (!m_cut)
      ahead();
    vertex(float(left), float(bottom));
    vertex(float(left + wide), float(bottom));
    vertex(float(strip ? left : left + wide), float(bottom + high));
    vertex(float(strip ? left + wide : left), float(bottom + high));
    if (mode == GL_TRIANGLES || ((mode == GL_POINTS || mode == GL_TRIANGLE_STRIP) && once(3))) {
      vertex(float(left + 2), float(bottom + 3));
      vertex(float(left + 9), float(bottom));
    }
    if (once(3))
      materialWithin(); // behind the last vertex
    glEnd();
  }

  /// Draws a primitive with so many vertices that it is drawn in parts before its End.
  void large(GLenum mode) {
    constexpr int kVertices = 270'000; // 4, 3 and 2 divide the number
    glBegin(mode);
    glColor4fv(color().data());
    for (int i = 0; i < kVertices; ++i) {
      if (i % 997 == 0 || (i > 200'000 && i % 5000 == 1))
        give(m_sides == 0 ? GL_FRONT_AND_BACK : GL_FRONT, kParts[m_random.below(4)]);
      if (i % 1500 == 0)
        glNormal3f(part(-8), part(-8), 1);
      const int place = i / 2;
      glVertex3i(place * 7 % kEdge, (i % 2 != 0 ? 2 : 0) + place / 13 % (kEdge - 2), 0);
    }
    glEnd();
  }

  void primitives() {
    constexpr GLenum kModes[] = {GL_QUADS,          GL_QUADS,      GL_TRIANGLE_FAN,
                                 GL_TRIANGLE_STRIP, GL_LINES,      GL_POINTS,
                                 GL_POLYGON,        GL_QUAD_STRIP, GL_TRIANGLES};
    m_mode = m_random.pick(kModes);
    if (once(40)) {
      m_mode = once(2) ? GL_POINTS : GL_LINES;
      return large(m_mode);
    }
    set(GL_LINE_SMOOTH, m_mode != GL_LINES && once(2)); // hosts split quads depending on that
    for (int count = m_random.between(1, 6); count > 0; --count) {
      primitive(m_mode);
      if (once(4))
        material(); // between them
    }
  }

  /// Returns the draw's state as text.
  [[nodiscard]] std::string state() const {
    std::string text = ": mode " + std::to_string(m_mode) + (m_grows ? ", grows" : "");
    GLint separate = 0;
    glGetIntegerv(GL_LIGHT_MODEL_COLOR_CONTROL, &separate);
    text += glIsEnabled(GL_LIGHTING) ? ", lit" : "";
    text += m_isTwoSided ? ", two sides" : "";
    text += separate == GL_SEPARATE_SPECULAR_COLOR ? ", separate specular" : "";
    if (glIsEnabled(GL_COLOR_MATERIAL)) {
      GLint face = 0, part = 0;
      glGetIntegerv(GL_COLOR_MATERIAL_FACE, &face);
      glGetIntegerv(GL_COLOR_MATERIAL_PARAMETER, &part);
      text += ", colours are " + std::to_string(part) + " of " + std::to_string(face);
    }
    return text;
  }
  /// Returns all materials as text.
  static std::string materials() {
    std::string text;
    for (const GLenum face : {GL_FRONT, GL_BACK})
      for (int i = 0; i < 5; ++i) {
        Four value{};
        glGetMaterialfv(face, kParts[i], value.data());
        for (const float each : value)
          text += ' ' + std::to_string(each);
      }
    return text;
  }

  Random m_random;
  Screen &m_screen;
  GLXDrawable m_window;
  GLXContext m_context;
  GLenum m_mode = GL_POINTS;
  bool m_cut;
  bool m_isTwoSided = false;
  bool m_isAhead = false; ///< materials only change before a primitive's first vertex
  bool m_grows = false;   ///< some parts are set for the first time later
  int m_rarely = 2;       ///< materials change at one of this many vertices; 0: none
  int m_sides = 0;        ///< 0: both at once
};

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  return drawSeeds(
      argc, argv, kEdge, "cut",
      [](int seed, software::Screen &screen, GLXDrawable window, bool cut) {
        Draws(std::uint64_t(seed), screen, window, cut).run("seed " + std::to_string(seed));
      });
}
