// Makes random draws whose every bit is compared: rasterizer-exact SEED COUNT. Each seed is a
// primitive of each kind with a random transform, whole or clipped by the view volume, with random
// inputs, many of them on edges of texels. It uses a random fragment program with nearest and
// linear filters, and draws to the window or to a float buffer. One in eight programs ends with an
// implementation-dependent result, and says so. Writes the pixels as records, which exact.py
// compares.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "exact_program.h"

namespace software {
namespace {

constexpr int kWidth = 89, kHeight = 61; // of both targets, in pixels

struct Kind {
  const char *name;
  GLenum mode;
  int corners;
};
constexpr Kind kKinds[] = {
    {"triangles", GL_TRIANGLES, 9}, {"strip", GL_TRIANGLE_STRIP, 6},  {"fan", GL_TRIANGLE_FAN, 6},
    {"quads", GL_QUADS, 4},         {"quad strip", GL_QUAD_STRIP, 6}, {"polygon", GL_POLYGON, 5},
    {"upright", GL_QUADS, 4},       {"many", GL_TRIANGLES, 180},      {"points", GL_POINTS, 5},
    {"lines", GL_LINES, 8},         {"line strip", GL_LINE_STRIP, 5}};

constexpr GLint kWraps[] = {GL_REPEAT, GL_REPEAT,          GL_CLAMP_TO_EDGE,
                            GL_CLAMP,  GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};
constexpr GLint kFormats[] = {GL_RGB8,  GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8, GL_ALPHA8, GL_RGB5,
                              GL_RGBA4, GL_RGB5_A1,    GL_INTENSITY8,        GL_RGBA16, GL_RGBA32F};

using Corner = std::array<float, 4>;

class Scene {
public:
  explicit Scene(std::uint64_t seed) : m_random(seed) {}

  void draw(const std::string &name, bool floats) {
    glViewport(0, 0, kWidth, kHeight);
    glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
    setTextures();
    for (const Kind &kind : kKinds) {
      m_cut = m_random.once(4);
      glProvokingVertex(m_random.once(2) ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
      const std::string program = anyProgram();
      const GLuint fragment =
          makeProgram(GL_FRAGMENT_PROGRAM_ARB, program.substr(program.find("!!")));
      glEnable(GL_FRAGMENT_PROGRAM_ARB);
      const std::string way = transform();
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      primitive(kind);
      record(name + " " + kind.name + (m_cut ? " cut " : " ") + way + ": " + program + takeErrors(),
             floats ? readFloats() : readRgba(0, 0, kWidth, kHeight));
      glDeleteProgramsARB(1, &fragment);
    }
    glDeleteTextures(kExactUnits, m_textures.data());
  }

private:
  std::string anyProgram() {
    const int which = m_random.below(8);
    return which == 0  ? nearProgram(m_random)
           : which < 3 ? plainProgram(m_random)
                       : exactProgram(m_random);
  }

  float real(float low, float high) { return m_random.real(low, high); }

  void setTextures() {
    glGenTextures(kExactUnits, m_textures.data());
    static constexpr int kSizes[] = {1, 2, 3, 5, 8, 13, 16, 32};
    m_size = m_random.pick(kSizes);
    const int other = m_random.pick(kSizes);
    for (int unit = 0; unit < kExactUnits; ++unit) {
      const GLenum target = kExactTargets[unit];
      glActiveTexture(GL_TEXTURE0 + GLenum(unit));
      glBindTexture(target, m_textures[std::size_t(unit)]);
      const GLint wrap = target == GL_TEXTURE_RECTANGLE ? GL_CLAMP_TO_EDGE : m_random.pick(kWraps);
      for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(target, axis, wrap);
      const GLint filter = m_random.once(4) ? GL_NEAREST : GL_LINEAR;
      glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
      glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
      setImages(target, m_random.once(2) ? GL_RGBA8 : m_random.pick(kFormats), other);
    }
    glActiveTexture(GL_TEXTURE0);
  }

  void setImages(GLenum target, GLint format, int other) {
    std::vector<unsigned char> texels(std::size_t(m_size) * std::size_t(std::max(m_size, other)) *
                                      std::size_t(std::max(m_size, other)) * 4);
    for (unsigned char &byte : texels)
      byte = static_cast<unsigned char>(m_random.bits() >> 20);
    if (target == GL_TEXTURE_1D)
      return glTexImage1D(target, 0, format, m_size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    if (target == GL_TEXTURE_3D)
      return glTexImage3D(target, 0, format, m_size, other, other, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          texels.data());
    if (target != GL_TEXTURE_CUBE_MAP)
      return glTexImage2D(target, 0, format, m_size, other, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          texels.data());
    for (int face = 0; face < 6; ++face) {
      for (unsigned char &byte : texels)
        byte = static_cast<unsigned char>(m_random.bits() >> 20);
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(face), 0, format, m_size, m_size, 0,
                   GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    }
  }

  std::string transform() {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    const float reach = m_cut ? 2.5f : 1.0f;
    m_w = 1;
    m_reach = reach;
    switch (m_random.below(5)) {
    case 0:
      return "untransformed";
    case 1:
      m_w = m_random.once(2) ? 4.0f : real(0.2f, 9);
      return m_w == 4 ? "of one w, 4" : "of one w";
    case 2:
      m_w = 0; // each vertex has its own
      return "of several w";
    case 3:
      glMatrixMode(GL_PROJECTION);
      glOrtho(0, kWidth, 0, kHeight, -1, 1); // pixels
      m_reach = 0;
      glMatrixMode(GL_MODELVIEW);
      return "pixels";
    default:
      m_reach = 4 * reach;
      glMatrixMode(GL_PROJECTION);
      glFrustum(-1, 1, -0.7, 0.7, 1, 30);
      glMatrixMode(GL_MODELVIEW);
      glTranslatef(0, 0, -8);
      glRotatef(real(0, 360), real(-1, 1), real(-1, 1), 1);
      return "perspective";
    }
  }

  /// Returns a coordinate that is often on an edge of texels.
  float coordinate() {
    switch (m_random.below(4)) {
    case 0:
      return float(m_random.between(-2, 3));
    case 1:
      return float(m_random.between(-m_size, 2 * m_size)) / float(m_size);
    case 2:
      return float(m_random.between(-m_size, 2 * m_size));
    default:
      return real(-2, 3);
    }
  }

  void inputs() {
    for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1, GL_TEXTURE2}) {
      const float s = coordinate(), t = m_random.once(3) ? s : coordinate();
      const float r = m_random.once(3) ? t : coordinate();
      glMultiTexCoord4f(unit, s, m_random.once(4) ? -t : t, r,
                        m_random.once(2) ? 1 : real(0.3f, 4));
    }
    glColor4f(real(0, 1), real(0, 1), real(0, 1), real(0, 1));
    glSecondaryColor3f(real(0, 1), real(0, 1), real(0, 1));
    glFogCoordf(real(-1, 2));
  }

  float place(float edge) {
    if (m_reach != 0)
      return real(-m_reach, m_reach);
    const float low = m_cut ? -edge : 0, high = m_cut ? 2 * edge : edge;
    return m_random.once(2) ? float(m_random.between(int(low), int(high))) : real(low, high);
  }

  std::vector<Corner> cornersOf(const Kind &kind) {
    std::vector<Corner> corners(std::size_t(kind.corners));
    const bool pixels = m_reach == 0;
    if (kind.name == std::string("many")) {
      for (std::size_t i = 0; i < corners.size(); ++i) { // small ones, at several places
        const bool first = i % 3 == 0;
        const float size = pixels ? 12 : 0.2f * m_reach;
        for (int c = 0; c < 2; ++c)
          corners[i][std::size_t(c)] = first
                                           ? place(c == 0 ? kWidth : kHeight)
                                           : corners[i - i % 3][std::size_t(c)] + real(-size, size);
        corners[i][2] = pixels ? real(-1, 1) : real(-m_reach, m_reach);
      }
      return corners;
    }
    for (Corner &corner : corners)
      corner = {place(kWidth), place(kHeight), pixels ? real(-1, 1) : real(-m_reach, m_reach), 1};
    if (kind.name == std::string("upright")) {
      const Corner a = corners[0], b = corners[2];
      corners = {a, {b[0], a[1], a[2], 1}, {b[0], b[1], a[2], 1}, {a[0], b[1], a[2], 1}};
    }
    return corners;
  }

  void primitive(const Kind &kind) {
    const std::vector<Corner> corners = cornersOf(kind);
    const float size = m_random.once(2) ? 1 : real(1, 9);
    (kind.mode == GL_POINTS ? glPointSize : glLineWidth)(size);
    const bool alike = m_random.once(4);
    glBegin(kind.mode);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (i == 0 || !alike)
        inputs();
      const float w = m_w == 0 ? real(0.3f, 5) : m_w;
      glVertex4f(corners[i][0] * w, corners[i][1] * w, corners[i][2] * w, w);
    }
    glEnd();
  }

  static std::vector<unsigned char> readFloats() {
    std::vector<unsigned char> bytes(std::size_t(kWidth) * kHeight * 16);
    glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_FLOAT, bytes.data());
    return bytes;
  }

  Random m_random;
  std::array<GLuint, kExactUnits> m_textures = {};
  int m_size = 1;
  bool m_cut = false;
  float m_reach = 1; ///< 0: in pixels
  float m_w = 1;     ///< 0: each vertex has its own
};

/// Selects the window, or a float framebuffer object.
void useTarget(bool floats) {
  static GLuint s_framebuffer = 0;
  if (!floats)
    return glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (s_framebuffer != 0)
    return glBindFramebuffer(GL_FRAMEBUFFER, s_framebuffer);
  s_framebuffer = makeFramebuffer();
  attachBuffer(GL_COLOR_ATTACHMENT0, GL_RGBA32F, kWidth, kHeight);
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
  for (int seed = first; seed < first + count; ++seed) {
    const bool floats = seed % 2 == 0;
    useTarget(floats);
    Scene(std::uint64_t(seed))
        .draw(std::string(floats ? "floats" : "window") + " seed " + std::to_string(seed), floats);
  }
  return 0;
}
