// Tests texture 0 of each target among named textures: rasterizer-default-textures SEED COUNT. Each
// seed is a random sequence of definitions, texels, feedback, draws and reads in one context, for
// some seeds in two of a share group in turns. Writes the results as records, which
// comparisons.py compares.
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 48; // of the window, in pixels
constexpr GLenum kTargets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP,
                               GL_TEXTURE_RECTANGLE};
constexpr const char *kNames[] = {"1D", "2D", "3D", "CUBE", "RECT"};

class Sequence {
public:
  Sequence(std::uint64_t seed, Screen &screen, GLXDrawable window)
      : m_random(seed), m_screen(screen), m_window(window) {
    m_contexts[0] = screen.makeContext();
    m_two = m_random.once(3);
    if (m_two)
      m_contexts[1] = screen.makeContext(m_contexts[0]);
  }
  ~Sequence() {
    if (m_two)
      m_screen.destroy(m_contexts[1]);
    m_screen.destroy(m_contexts[0]);
  }
  Sequence(const Sequence &) = delete;
  Sequence &operator=(const Sequence &) = delete;

  void run(const std::string &name) {
    for (int i = m_two ? 1 : 0; i >= 0; --i)
      enter(i);
    glGenTextures(5, m_named);
    for (std::size_t i = 0; i < 5; ++i) {
      bind(i, false);
      define(i);
    }
    for (int i = 0; i < 30; ++i)
      command(i, name);
    record(name + " at the end", readRgba(0, 0, kEdge, kEdge));
    record(name + " errors" + takeErrors(), {});
  }

private:
  void enter(int number) {
    m_screen.makeCurrent(m_window, m_contexts[number]);
    m_now = number;
    if (std::exchange(m_ready[number], true))
      return;
    glViewport(0, 0, kEdge, kEdge);
    glDisable(GL_DITHER);
    glClear(GL_COLOR_BUFFER_BIT);
    for (std::size_t i = 0; i < 5; ++i) {
      const std::string text = std::string("!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], "
                                           "texture[0], ") +
                               kNames[i] + ";\nMUL result.color, t, fragment.color;\nEND\n";
      m_programs[number][i] = makeProgram(GL_FRAGMENT_PROGRAM_ARB, text);
    }
  }

  /// Binds the target's named texture, or its texture 0.
  void bind(std::size_t target, bool zero) {
    glBindTexture(kTargets[target], zero ? 0 : m_named[target]);
  }

  [[nodiscard]] std::vector<unsigned char> texels(int count) {
    std::vector<unsigned char> bytes;
    for (int i = 0; i < 4 * count; ++i)
      bytes.push_back(static_cast<unsigned char>(m_random.bits()));
    return bytes;
  }

  void define(std::size_t target) {
    const GLenum name = kTargets[target];
    const int edge = 4 << m_random.below(3);
    const auto data = texels(edge * edge * edge);
    const GLint internal = m_random.once(3) ? GL_RGB8 : GL_RGBA8;
    if (target == 0)
      glTexImage1D(name, 0, internal, edge, 0, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
    else if (target == 2)
      glTexImage3D(name, 0, internal, edge, edge, edge, 0, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
    else if (target == 3)
      for (GLenum face = 0; face < 6; ++face)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, internal, edge, edge, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, data.data() + std::size_t(face) * 4);
    else
      glTexImage2D(name, 0, internal, edge, edge, 0, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
    glTexParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }

  [[nodiscard]] GLenum imageOf(std::size_t target) {
    return target == 3 ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(m_random.below(6))
                       : kTargets[target];
  }

  void give(std::size_t target) {
    const auto data = texels(64);
    const GLenum image = imageOf(target);
    const GLenum format = m_random.once(2) ? GL_RGBA : GL_BGRA;
    if (target == 0)
      glTexSubImage1D(image, 0, m_random.below(3), 3, format, GL_UNSIGNED_BYTE, data.data());
    else if (target == 2)
      glTexSubImage3D(image, 0, 1, 0, m_random.below(3), 3, 4, 1, format, GL_UNSIGNED_BYTE,
                      data.data());
    else
      glTexSubImage2D(image, 0, m_random.below(2), 0, 3, 4, format, GL_UNSIGNED_BYTE, data.data());
  }

  void feedback(std::size_t target) {
    const GLenum image = imageOf(target);
    const int x = m_random.below(kEdge - 16), y = m_random.below(kEdge - 16);
    if (target == 0)
      glCopyTexSubImage1D(image, 0, 0, x, y, 4);
    else if (target == 2)
      glCopyTexSubImage3D(image, 0, 0, 0, m_random.below(4), x, y, 4, 4);
    else if (target != 3 && m_random.once(2))
      glCopyTexImage2D(image, 0, GL_RGBA8, x, y, 16, 16, 0);
    else
      glCopyTexSubImage2D(image, 0, 0, 0, x, y, 4, 4);
  }

  void draw(std::size_t target) {
    const bool fixed = m_random.once(4) && target < 2;
    for (std::size_t i = 0; i < 2; ++i)
      (fixed && i == target ? glEnable : glDisable)(kTargets[i]);
    (fixed ? glDisable : glEnable)(GL_FRAGMENT_PROGRAM_ARB);
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, m_programs[m_now][target]);
    const float scale = target == 4 ? 4.0f : 1.0f;
    const float left = float(m_random.below(5)) / 4 - 1, bottom = float(m_random.below(5)) / 4 - 1;
    glColor4f(1, float(m_random.below(9)) / 8, 1, 1);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
      // No pixel center is between two texels.
      const float x = float(i % 2), y = float(i / 2), s = 0.0131f + 0.967f * x,
                  t = 0.0117f + 0.971f * y;
      glTexCoord3f(target == 3 ? 0.6f * s - 0.3123f : s * scale,
                   target == 3 ? 0.6f * t - 0.2871f : t * scale, target == 3 ? 0.931f : 0.3917f);
      glVertex2f(left + x, bottom + y);
    }
    glEnd();
  }

  void command(int number, const std::string &name) {
    const auto target = std::size_t(m_random.below(5));
    const std::string at = name + " after " + std::to_string(number);
    bind(target, !m_random.once(3));
    switch (m_random.below(12)) {
    case 0:
    case 1:
      return define(target);
    case 2:
    case 3:
      return give(target);
    case 4:
    case 5:
      return feedback(target);
    case 6:
      if (target == 1) {
        GLint width = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        std::vector<unsigned char> bytes(std::size_t(width) * std::size_t(width) * 4);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        record(at + ": texels", bytes);
      }
      return;
    case 7:
      if (m_random.once(3)) {
        glDeleteTextures(1, &m_named[target]); // the target then has texture 0
        glGenTextures(1, &m_named[target]);
      } else if (m_two) {
        enter(1 - m_now);
      }
      return;
    default:
      draw(target);
      if (m_random.once(4))
        record(at, readRgba(0, 0, kEdge, kEdge));
    }
  }

  Random m_random;
  Screen &m_screen;
  GLXDrawable m_window;
  GLXContext m_contexts[2] = {};
  bool m_two = false, m_ready[2] = {};
  int m_now = 0;
  GLuint m_named[5] = {}, m_programs[2][5] = {};
};

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  return drawSeeds(
      argc, argv, kEdge, nullptr, [](int seed, software::Screen &screen, GLXDrawable window, bool) {
        Sequence(std::uint64_t(seed), screen, window).run("seed " + std::to_string(seed));
      });
}
