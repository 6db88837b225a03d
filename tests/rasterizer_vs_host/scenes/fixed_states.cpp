// Makes single fixed-function draws with all state random: rasterizer-fixed-states SEED COUNT. Each
// seed is a few draws, each with its own state: matrices, lights and materials, fog, color sum, and
// four texture units of every target with generated coordinates and every environment. Textures
// have colors or depths, compared or not. Writes pictures as records, which comparisons.py
// compares.
#include <cstdlib>

#include "fixed_textures.h"

namespace software {
namespace {

constexpr int kEdge = 64; // of the window, in pixels
constexpr int kDraws = 8, kUnits = 4;

class Draws {
public:
  Draws(std::uint64_t seed, Screen &screen, GLXDrawable window)
      : m_random(seed), m_screen(screen), m_window(window), m_context(screen.makeContext()),
        m_hasLevels(m_random.once(3)) {
    screen.makeCurrent(window, m_context);
    glViewport(0, 0, kEdge, kEdge);
    glDisable(GL_DITHER);
    glClearColor(0.25f, 0.5f, 0.125f, 0.5f);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int unit = 0; unit < kUnits; ++unit) {
      glActiveTexture(GL_TEXTURE0 + GLenum(unit));
      m_textures[unit] = makeFixedTexture(m_random, m_hasLevels);
    }
  }
  ~Draws() {
    for (const FixedTexture &texture : m_textures)
      glDeleteTextures(1, &texture.name);
    m_screen.destroy(m_context);
  }
  Draws(const Draws &) = delete;
  Draws &operator=(const Draws &) = delete;

  void run(const std::string &name) {
    for (int draw = 0; draw < kDraws; ++draw) {
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      glPushAttrib(GL_ALL_ATTRIB_BITS);
      // Fog is off with a color sum: Mesa 22.3.6 applies fog to the sum before clamping it,
      // although clamping comes first (OpenGL 1.4, 3.9).
      m_fog = once(2);
      // Flat shading has no textures, all of which may be multiplied by 0: hosts split quads
      // depending on whether a color of the provoking last vertex is read.
      m_isFlat = once(4);
      for (bool &on : m_isOn)
        on = !once(3) && !m_isFlat;
      matrices();
      lighting();
      for (int unit = 0; unit < kUnits; ++unit)
        environment(unit);
      fog();
      pixels();
      primitive();
      glPopAttrib();
      record(name + ", draw " + std::to_string(draw) + (m_hasLevels ? ", levels" : ""),
             readRgba(0, 0, kEdge, kEdge));
      m_screen.swap(m_window);
    }
    record(name + " errors" + takeErrors(), {});
  }

private:
  /// Returns a multiple of 1/8.
  [[nodiscard]] float part(int low = 0, int high = 8) {
    return float(m_random.between(low, high)) / 8;
  }
  [[nodiscard]] bool once(int of) { return m_random.once(of); }
  void set(GLenum capability, bool on) { (on ? glEnable : glDisable)(capability); }
  struct Four {
    float values[4];
    operator const float *() const { return values; }
  };
  Four color() { return {{part(), part(), part(), part()}}; }
  Four around() { return {{part(-8), part(-8), part(-8), part(-8)}}; }

  /// Sets matrices that leave the vertices in window coordinates, so that pixel borders are equal
  /// on both sides.
  void matrices() {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, kEdge, 0, kEdge, -64, 64);
    m_scale = once(2) ? 1.0f : float(m_random.between(1, 6)) / 2;
    m_lift = once(2) ? 0.0f : part(-16, 16);
    glScalef(1 / m_scale, 1 / m_scale, 1 / m_scale);
    glTranslatef(0, 0, -m_lift);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, m_lift);
    glScalef(m_scale, m_scale, m_scale);
    glMatrixMode(GL_TEXTURE);
    for (int unit = 0; unit < kUnits; ++unit) {
      glActiveTexture(GL_TEXTURE0 + GLenum(unit));
      glLoadIdentity();
      if (once(3)) {
        glRotatef(float(m_random.below(90)), part(-8), part(-8), 1);
        glTranslatef(part(), part(), part());
      }
    }
    glMatrixMode(GL_MODELVIEW);
  }

  void lighting() {
    m_isLit = !once(3);
    set(GL_LIGHTING, m_isLit);
    set(GL_COLOR_MATERIAL, once(2));
    set(GL_NORMALIZE, once(2));
    set(GL_RESCALE_NORMAL, once(3));
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, m_random.below(2));
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, m_random.below(2));
    const bool separate = once(2) && !m_fog;
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                  separate ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, color());
    for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 8; ++light) {
      set(light, once(3));
      glLightfv(light, GL_AMBIENT, color());
      glLightfv(light, GL_DIFFUSE, around());
      glLightfv(light, GL_SPECULAR, color());
      const float position[4] = {float(m_random.between(-40, 90)), float(m_random.between(-40, 90)),
                                 float(m_random.between(8, 60)), float(m_random.below(2))};
      glLightfv(light, GL_POSITION, position);
      const float towards[4] = {part(-8), part(-8), -1, 0};
      glLightfv(light, GL_SPOT_DIRECTION, towards);
      // The cones are wide, as at the edge of a cone the last bit decides.
      glLightf(light, GL_SPOT_CUTOFF, once(3) ? 90.0f : 180.0f);
      glLightf(light, GL_SPOT_EXPONENT, float(m_random.below(6)));
      glLightf(light, GL_CONSTANT_ATTENUATION, 0.5f + part());
      glLightf(light, GL_LINEAR_ATTENUATION, once(2) ? 0 : part() / 32);
      glLightf(light, GL_QUADRATIC_ATTENUATION, once(2) ? 0 : part() / 1024);
    }
    // BACK alone is not used: Mesa 22.3.6 then has green and blue of 1, for any materials.
    constexpr GLenum kFaces[] = {GL_FRONT, GL_FRONT_AND_BACK};
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
      glMaterialfv(face, GL_AMBIENT, color());
      glMaterialfv(face, GL_DIFFUSE, color());
      glMaterialfv(face, GL_SPECULAR, color());
      glMaterialfv(face, GL_EMISSION, color());
      // The shininess is never 0: Mesa 22.3.6 attenuates such a highlight too much, although n^0 is
      // 1.
      glMaterialf(face, GL_SHININESS, float(m_random.between(1, 40)));
    }
    constexpr GLenum kParts[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION,
                                 GL_AMBIENT_AND_DIFFUSE};
    const GLenum face = m_random.pick(kFaces);
    glColorMaterial(face, m_random.pick(kParts));
  }

  void environment(int unit) {
    glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    set(m_textures[unit].target, m_isOn[unit]);
    chooseComparison(m_random, m_textures[unit], m_hasLevels);
    constexpr GLint kModes[] = {GL_COMBINE, GL_COMBINE, GL_MODULATE, GL_REPLACE,
                                GL_BLEND,   GL_ADD,     GL_DECAL};
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
              kModes[m_random.below(m_textures[unit].hasDecal() ? 7 : 6)]);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color());
    constexpr GLint kRgb[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                              GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
    constexpr GLint kAlpha[] = {GL_REPLACE,    GL_MODULATE,    GL_ADD,
                                GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT};
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, kRgb[m_random.below(m_hasLevels ? 6 : 8)]);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, m_random.pick(kAlpha));
    constexpr GLint kOperands[] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR,
                                   GL_ONE_MINUS_SRC_COLOR};
    for (GLenum i = 0; i < 3; ++i) {
      glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB + i, source());
      glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA + i, source());
      glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB + i, m_random.pick(kOperands));
      glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA + i, kOperands[m_random.below(2)]);
    }
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, once(4) && !m_hasLevels ? 2.0f : 1.0f);
    glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, once(4) && !m_hasLevels ? 4.0f : 1.0f);
    generated();
  }
  /// Returns an argument's source; the texture of a disabled unit is undefined.
  GLint source() {
    constexpr GLint kSources[] = {GL_TEXTURE,       GL_PREVIOUS, GL_CONSTANT,
                                  GL_PRIMARY_COLOR, GL_TEXTURE0, GL_TEXTURE0};
    const GLint source = m_random.pick(kSources);
    const int unit = m_random.below(kUnits);
    return source != GL_TEXTURE0 ? source : m_isOn[unit] ? GL_TEXTURE0 + unit : GL_PREVIOUS;
  }

  void generated() {
    constexpr GLenum kCoordinates[] = {GL_S, GL_T, GL_R, GL_Q};
    constexpr GLint kModes[] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_NORMAL_MAP, GL_REFLECTION_MAP,
                                GL_SPHERE_MAP};
    for (const GLenum coordinate : kCoordinates) {
      const int kinds = coordinate == GL_Q ? 2 : coordinate == GL_R ? 4 : 5;
      glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, kModes[m_random.below(kinds)]);
      // The coordinate is never at a border between two texels.
      const float last = coordinate == GL_Q ? 1.0f : part() + 0.01f;
      const float plane[4] = {part(-8) / 64, part(-8) / 64, part(-8) / 64, last};
      glTexGenfv(coordinate, GL_OBJECT_PLANE, plane);
      glTexGenfv(coordinate, GL_EYE_PLANE, plane);
      set(GL_TEXTURE_GEN_S + (coordinate - GL_S), once(4));
    }
  }

  void fog() {
    set(GL_FOG, m_fog);
    constexpr GLint kModes[] = {GL_LINEAR, GL_EXP, GL_EXP2};
    glFogi(GL_FOG_MODE, m_random.pick(kModes));
    constexpr GLint kDistances[] = {GL_EYE_RADIAL_NV, GL_EYE_PLANE, GL_EYE_PLANE_ABSOLUTE_NV};
    glFogi(GL_FOG_DISTANCE_MODE_NV, m_random.pick(kDistances));
    glFogi(GL_FOG_COORD_SRC, once(2) ? GL_FOG_COORD : GL_FRAGMENT_DEPTH);
    glFogf(GL_FOG_START, part(-8));
    glFogf(GL_FOG_END, 1.5f + part());
    glFogf(GL_FOG_DENSITY, part() / 2);
    glFogfv(GL_FOG_COLOR, color());
    // Nothing is added to lit primitives of a single color; but Mesa splits quads depending on
    // whether colors are read.
    set(GL_COLOR_SUM, once(2) && !m_fog && !m_isLit);
  }

  void pixels() {
    glShadeModel(m_isFlat ? GL_FLAT : GL_SMOOTH);
    set(GL_BLEND, once(4));
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    set(GL_CULL_FACE, once(8));
    glFrontFace(once(3) ? GL_CW : GL_CCW);
    glPointSize(float(m_random.between(1, 20)));
    glLineWidth(float(m_random.between(1, 8)));
  }

  void vertex(int x, int y) {
    glColor4fv(color());
    glSecondaryColor3f(part(), part(), part());
    glFogCoordf(part(-8, 16));
    glNormal3f(part(-8), part(-8), once(4) ? -1.0f : 1.0f);
    for (int unit = 0; unit < kUnits; ++unit) {
      // Rectangles have coordinates in texels.
      const float size = m_textures[unit].target == GL_TEXTURE_RECTANGLE ? 8.0f : 1.0f;
      // No two are equal, as a cube's face would be chosen by chance.
      glMultiTexCoord4f(GL_TEXTURE0 + GLenum(unit), size * part(-8, 16) + 0.01f,
                        size * part(-8, 16) + 0.02f, size * part(-8, 16) + 0.03f,
                        once(2) ? 1.0f : 0.5f + part());
    }
    // Perspective does not move vertices in the window.
    const float w = m_perspective ? 0.5f + part() : 1.0f;
    glVertex4f(float(x) * w, float(y) * w, part(-8) * w, w);
  }

  void primitive() {
    m_perspective = once(3);
    const int left = m_random.below(24), bottom = m_random.below(24);
    const int wide = m_random.between(8, 36), high = m_random.between(8, 36);
    constexpr GLenum kModes[] = {GL_QUADS, GL_QUADS,  GL_TRIANGLE_FAN, GL_TRIANGLE_STRIP,
                                 GL_LINES, GL_POINTS, GL_POLYGON,      GL_QUAD_STRIP};
    const GLenum mode = m_random.pick(kModes);
    const bool strip = mode == GL_TRIANGLE_STRIP || mode == GL_QUAD_STRIP;
    const bool list = once(4);
    if (list)
      glNewList(1, GL_COMPILE);
    glBegin(mode);
    vertex(left, bottom);
    vertex(left + wide, bottom);
    vertex(strip ? left : left + wide, bottom + high);
    vertex(strip ? left + wide : left, bottom + high);
    glEnd();
    if (list) {
      glEndList();
      glCallList(1);
      glDeleteLists(1, 1);
    }
  }

  Random m_random;
  Screen &m_screen;
  GLXDrawable m_window;
  GLXContext m_context;
  /// Textures have levels of detail, and environments multiply by at most 1
  bool m_hasLevels;
  FixedTexture m_textures[kUnits];
  bool m_isOn[kUnits] = {}, m_isLit = false, m_isFlat = false;
  float m_scale = 1, m_lift = 0;
  bool m_perspective = false, m_fog = false;
};

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  return drawSeeds(argc, argv, kEdge, nullptr,
                   [](int seed, software::Screen &screen, GLXDrawable window, bool) {
                     Draws(std::uint64_t(seed), screen, window).run("seed " + std::to_string(seed));
                   });
}
