// Draws frames of an application that never loads a program: rasterizer-fixed SEED COUNT. Each seed
// is a few frames in a window: lights and materials, texture environments on two units, generated
// coordinates, fog, depth, stencil, blending, alpha, scissors, clip planes; primitives between
// Begin and End, from arrays and from display lists. Writes pictures as records, which
// comparisons.py compares. With LISTS_WHOLE in the environment, lists do not depend on the current
// state.
#include <algorithm>
#include <cstdlib>

#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 64; // of the window, in pixels
constexpr int kFrames = 6, kDraws = 8;

class Scene {
public:
  Scene(std::uint64_t seed, Screen &screen, GLXDrawable window)
      : m_random(seed), m_materials(seed), m_screen(screen), m_window(window),
        m_context(screen.makeContext()) {
    screen.makeCurrent(window, m_context);
  }
  ~Scene() { m_screen.destroy(m_context); }
  Scene(const Scene &) = delete;
  Scene &operator=(const Scene &) = delete;

  void run(const std::string &name, bool each) {
    setUp();
    for (int frame = 0; frame < kFrames; ++frame) {
      glClearColor(unit(), unit(), unit(), 1);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
      for (int draw = 0; draw < kDraws; ++draw) {
        const int what = change(), which = shape();
        if (each)
          record(name + ", frame " + std::to_string(frame) + ", draw " + std::to_string(draw) +
                     ": change " + std::to_string(what) + ", shape " + std::to_string(which),
                 readRgba(0, 0, kEdge, kEdge));
      }
      record(name + ", frame " + std::to_string(frame), readRgba(0, 0, kEdge, kEdge));
      m_screen.swap(m_window);
    }
    record(name + " shows", m_screen.grab(kEdge, kEdge));
    record(name + " errors" + takeErrors(), {});
  }

private:
  /// Returns a multiple of 1/8 from 0 to 1.
  [[nodiscard]] float unit() { return float(m_random.below(9)) / 8; }
  void color() { glColor4f(unit(), unit(), unit(), unit()); }

  void setUp() {
    glViewport(0, 0, kEdge, kEdge);
    glDisable(GL_DITHER);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, kEdge, 0, kEdge, -2, 2);
    glMatrixMode(GL_MODELVIEW);
    glGenTextures(2, m_textures);
    for (int i = 0; i < 2; ++i) {
      unsigned char texels[4 * 8 * 8];
      for (unsigned char &texel : texels)
        texel = static_cast<unsigned char>(m_random.bits());
      glActiveTexture(GL_TEXTURE0 + GLenum(i));
      glBindTexture(GL_TEXTURE_2D, m_textures[i]);
      constexpr GLint kFormats[] = {GL_RGBA, GL_RGB, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY};
      m_formats[i] = m_random.pick(kFormats);
      glTexImage2D(GL_TEXTURE_2D, 0, m_formats[i], 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glEnable(GL_TEXTURE_2D); // for unit 1: a unit whose texture the other one reads must be enabled
    m_list = glGenLists(1);
    compileList(nullptr);
  }

  /// Compiles a list. \param normal of the first vertices; null: the current one at the call, as
  /// for their color
  void compileList(const float *normal) const {
    glNewList(m_list, GL_COMPILE);
    glBegin(GL_QUAD_STRIP);
    if (normal)
      glNormal3fv(normal);
    glVertex2i(8, 8);
    glVertex2i(8, 56);
    glNormal3f(0.6f, 0, 0.8f);
    glVertex2i(40, 8);
    glVertex2i(40, 56);
    glEnd();
    glEndList();
  }

  void set(GLenum capability, bool on) { (on ? glEnable : glDisable)(capability); }

  int change() {
    const int what = m_random.below(12);
    change(what);
    return what;
  }
  void change(int what) {
    switch (what) {
    case 0:
      return lighting();
    case 1:
    case 2:
      return environment();
    case 3:
      return generated();
    case 4:
      return fog();
    case 5:
      set(GL_DEPTH_TEST, m_random.once(2));
      return glDepthFunc(m_random.once(2) ? GL_LEQUAL : GL_GREATER);
    case 6:
      set(GL_STENCIL_TEST, m_random.once(2));
      glStencilFunc(m_random.once(2) ? GL_ALWAYS : GL_EQUAL, m_random.below(3), 0xff);
      return glStencilOp(GL_KEEP, GL_INCR, m_random.once(2) ? GL_REPLACE : GL_INCR);
    case 7:
      set(GL_BLEND, m_random.once(2));
      return glBlendFunc(GL_SRC_ALPHA, m_random.once(2) ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
    case 8:
      set(GL_ALPHA_TEST, m_random.once(2));
      return glAlphaFunc(GL_GREATER, 0.3f);
    case 9:
      set(GL_SCISSOR_TEST, m_random.once(2));
      return glScissor(m_random.below(20), m_random.below(20), 40, 40);
    case 10:
      glShadeModel(m_random.once(2) ? GL_FLAT : GL_SMOOTH);
      return glPolygonMode(GL_FRONT_AND_BACK, m_random.once(6) ? GL_POINT : GL_FILL);
    default:
      set(GL_CLIP_PLANE0, m_random.once(2));
      const double plane[4] = {1, 0, 0, -double(m_random.between(8, 24)) - 0.5};
      glClipPlane(GL_CLIP_PLANE0, plane);
    }
  }

  void fog() {
    set(GL_FOG, m_random.once(2));
    glFogi(GL_FOG_MODE, GL_LINEAR);
    constexpr GLint kDistances[] = {GL_EYE_RADIAL_NV, GL_EYE_PLANE, GL_EYE_PLANE_ABSOLUTE_NV};
    glFogi(GL_FOG_DISTANCE_MODE_NV, m_random.pick(kDistances));
    glFogf(GL_FOG_START, unit());
    glFogf(GL_FOG_END, 1.5f + unit());
  }

  void lighting() {
    set(GL_LIGHTING, !m_random.once(3));
    set(GL_COLOR_MATERIAL, m_random.once(2));
    set(GL_NORMALIZE, m_random.once(2));
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, m_random.below(2));
    for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 3; ++light) {
      set(light, m_random.once(2));
      const float diffuse[4] = {unit(), unit(), unit(), 1};
      const float position[4] = {float(m_random.between(-40, 90)), 32, 24,
                                 float(m_random.below(2))};
      glLightfv(light, GL_DIFFUSE, diffuse);
      glLightfv(light, GL_POSITION, position);
      glLightf(light, GL_LINEAR_ATTENUATION, unit() / 32);
    }
    const float specular[4] = {unit(), unit(), unit(), 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    shininess(GL_FRONT_AND_BACK, m_random);
  }

  /// Sets a shininess that is never 0: Mesa 22.3.6 attenuates such a highlight too much, although
  /// n^0 is 1 (OpenGL 1.4, 2.13.1).
  static void shininess(GLenum face, Random &random) {
    glMateriali(face, GL_SHININESS, std::max(random.below(16), 1));
  }

  void environment() {
    const int which = m_random.below(2);
    glActiveTexture(GL_TEXTURE0 + GLenum(which));
    if (which == 0)
      set(GL_TEXTURE_2D, !m_random.once(4));
    // DECAL is only defined for two formats (OpenGL 1.4, table 3.21).
    const bool decal = m_formats[which] == GL_RGB || m_formats[which] == GL_RGBA;
    constexpr GLint kModes[] = {GL_MODULATE, GL_REPLACE, GL_BLEND, GL_ADD, GL_COMBINE, GL_DECAL};
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, kModes[m_random.below(decal ? 6 : 5)]);
    constexpr GLint kCombines[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,     GL_ADD_SIGNED,
                                   GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB};
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, m_random.pick(kCombines));
    constexpr GLint kSources[] = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT, GL_PRIMARY_COLOR,
                                  GL_TEXTURE1};
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, m_random.pick(kSources));
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, m_random.pick(kSources));
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB,
              m_random.once(2) ? GL_SRC_COLOR : GL_ONE_MINUS_SRC_COLOR);
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, m_random.once(3) ? 2.0f : 1.0f);
    const float constant[4] = {unit(), unit(), unit(), unit()};
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
  }

  void generated() {
    glActiveTexture(GL_TEXTURE0 + GLenum(m_random.below(2)));
    const bool on = m_random.once(2);
    set(GL_TEXTURE_GEN_S, on);
    set(GL_TEXTURE_GEN_T, on);
    // No pixel center is between two texels.
    const float s[4] = {1.0f / 64, 0, 0, 0.0031f}, t[4] = {0, 1.0f / 64, 0, 0.0027f};
    const GLint mode = m_random.once(2) ? GL_OBJECT_LINEAR : GL_EYE_LINEAR;
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, mode);
    glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, mode);
    glTexGenfv(GL_S, mode == GL_OBJECT_LINEAR ? GL_OBJECT_PLANE : GL_EYE_PLANE, s);
    glTexGenfv(GL_T, mode == GL_OBJECT_LINEAR ? GL_OBJECT_PLANE : GL_EYE_PLANE, t);
  }

  /// Draws a rectangle with corners on pixel corners.
  int shape() {
    const int which = m_random.below(5);
    shape(which);
    return which;
  }
  void shape(int which) {
    const int x = m_random.below(40), y = m_random.below(40);
    const int wide = m_random.between(4, 24), high = m_random.between(4, 24);
    const float z = float(m_random.between(-4, 4)) / 4;
    color();
    glNormal3f(0, m_random.once(2) ? 0.6f : 0, m_random.once(4) ? -0.8f : 0.8f);
    const float corners[4][2] = {{float(x), float(y)},
                                 {float(x + wide), float(y)},
                                 {float(x + wide), float(y + high)},
                                 {float(x), float(y + high)}};
    switch (which) {
    case 0: {
      glEnableClientState(GL_VERTEX_ARRAY);
      glVertexPointer(2, GL_FLOAT, 0, corners);
      constexpr GLubyte kOrder[] = {0, 1, 2, 0, 2, 3};
      if (m_random.once(2))
        glDrawArrays(GL_TRIANGLE_FAN, 0, 4);
      else
        glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, kOrder);
      glDisableClientState(GL_VERTEX_ARRAY);
      return;
    }
    case 1:
      if (std::getenv("LISTS_WHOLE")) {
        float normal[4];
        glGetFloatv(GL_CURRENT_NORMAL, normal);
        compileList(normal);
      }
      return glCallList(m_list);
    case 2:
      // Mesa 22.3.6 draws it as QUADS, whose flat color is the last corner's; section 2.10 says
      // POLYGON.
      glShadeModel(GL_SMOOTH);
      return glRecti(x, y, x + wide, y + high);
    default:
      const bool isQuads = m_random.once(2);
      glBegin(isQuads ? GL_QUADS : GL_POLYGON);
      // This is legal between Begin and End: before a vertex, and after a complete quadrilateral.
      material();
      quadrilateral(corners, z);
      if (isQuads && m_materials.once(2)) {
        material();
        quadrilateral(corners, z - 0.25f);
      }
      glEnd();
    }
  }

  void quadrilateral(const float (&corners)[4][2], float z) {
    for (int i = 0; i < 4; ++i) {
      const float s = 0.0131f + 0.967f * float(i == 1 || i == 2);
      const float t = 0.0117f + 0.971f * float(i / 2);
      glMultiTexCoord2f(GL_TEXTURE0, s, t);
      glMultiTexCoord2f(GL_TEXTURE1, t, s);
      glVertex3f(corners[i][0] + (z < 0 ? 3.0f : 0.0f), corners[i][1], z);
    }
  }

  void material() {
    if (!m_materials.once(3))
      return;
    const auto part = [&] { return float(m_materials.below(9)) / 8; };
    const float color[4] = {part(), part(), part(), 1};
    glMaterialfv(GL_FRONT_AND_BACK, m_materials.once(2) ? GL_DIFFUSE : GL_AMBIENT_AND_DIFFUSE,
                 color);
    if (m_materials.once(2))
      shininess(GL_FRONT, m_materials);
  }

  Random m_random;
  Random m_materials; ///< separate, so that the other scenes of a seed do not change
  Screen &m_screen;
  GLXDrawable m_window;
  GLXContext m_context;
  GLuint m_textures[2] = {}, m_list = 0;
  GLint m_formats[2] = {};
};

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  return drawSeeds(
      argc, argv, kEdge, "each",
      [](int seed, software::Screen &screen, GLXDrawable window, bool each) {
        Scene(std::uint64_t(seed), screen, window).run("seed " + std::to_string(seed), each);
      });
}
