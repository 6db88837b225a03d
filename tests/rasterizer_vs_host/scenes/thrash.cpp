// Mixes draws of the rasterizer with draws that only the host supports, on the same images in every
// frame: rasterizer-thrash cheap|dear FRAMES. Records the last picture, and the time of each frame
// in microseconds.
#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include "surface.h"

namespace software {

namespace {

/// A kind of frame. \param side width and height in pixels
/// \param passes draws of a fragment program in a frame, each followed by a GLSL draw if `mixed`;
/// otherwise one GLSL draw ends the frame
/// \param scissor width and height of a pass in pixels
struct Kind {
  const char *name;
  int side, passes;
  bool mixed;
  int scissor;
};
constexpr Kind kKinds[] = {
    // It draws a few pixels between two moves of sixteen megabytes: the host should do it all.
    {"cheap", 2048, 4, true, 8},
    // It draws millions of pixels for one move: the rasterizer should keep it.
    {"dear", 1024, 6, false, 1024},
};

/// Makes an application's own shader, which the host draws.
GLuint makeGlsl() {
  const char *const text = "uniform sampler2D source;\n"
                           "void main() { gl_FragColor = texture2D(source, vec2(0.5)).bgra; }\n";
  const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked)
    std::abort();
  return program;
}

class Thrash {
public:
  explicit Thrash(const Kind &kind) : m_kind(kind) {
    std::vector<unsigned char> texels(std::size_t(kind.side) * std::size_t(kind.side) * 4);
    Random random(7);
    for (unsigned char &value : texels)
      value = static_cast<unsigned char>(random.bits());
    glGenTextures(2, m_textures);
    glGenFramebuffers(2, m_framebuffers);
    for (int i = 0; i < 2; ++i) {
      glBindTexture(GL_TEXTURE_2D, m_textures[i]);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kind.side, kind.side, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                   texels.data());
      glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffers[i]);
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_textures[i], 0);
    }
    (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB, "!!ARBfp1.0\n"
                                               "TEMP c, s;\n"
                                               "TEX c, fragment.texcoord[0], texture[0], 2D;\n"
                                               "MUL s, c, c.yzwx;\n"
                                               "MAD s, s, { 0.25, 0.25, 0.25, 0.25 }, c.wxyz;\n"
                                               "FRC result.color, s;\n"
                                               "END\n");
    m_glsl = makeGlsl();
    glViewport(0, 0, kind.side, kind.side);
  }

  void frame() {
    for (int pass = 0; pass < m_kind.passes; ++pass) {
      program(m_kind.scissor);
      if (m_kind.mixed || pass + 1 == m_kind.passes)
        shader();
    }
    glFinish();
  }

  [[nodiscard]] std::vector<unsigned char> picture() const {
    return readRgba(0, 0, m_kind.side, m_kind.side);
  }

private:
  void target(int pixels) {
    m_to = 1 - m_to;
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffers[m_to]);
    glBindTexture(GL_TEXTURE_2D, m_textures[1 - m_to]);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, pixels, pixels);
  }
  static void quad() {
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0), glVertex2f(-1, -1);
    glTexCoord2f(1, 0), glVertex2f(1, -1);
    glTexCoord2f(1, 1), glVertex2f(1, 1);
    glTexCoord2f(0, 1), glVertex2f(-1, 1);
    glEnd();
  }
  void program(int pixels) {
    target(pixels);
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    quad();
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
  }
  void shader() {
    target(4);
    glUseProgram(m_glsl);
    quad();
    glUseProgram(0);
  }

  const Kind &m_kind;
  GLuint m_textures[2] = {}, m_framebuffers[2] = {}, m_glsl = 0;
  int m_to = 0;
};

} // namespace

} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  const Kind *const kind = rowNamed(kKinds, argc, argv);
  software::Screen screen;
  if (!kind || argc != 3 || !screen.open())
    return 1;
  const GLXDrawable window = screen.makeWindow(64, 64);
  const GLXContext context = screen.makeContext();
  screen.makeCurrent(window, context);
  Thrash thrash(*kind);
  std::string times;
  for (int i = 0; i < std::atoi(argv[2]); ++i) {
    const auto begin = std::chrono::steady_clock::now();
    thrash.frame();
    const auto time = std::chrono::steady_clock::now() - begin;
    times +=
        std::to_string(std::chrono::duration_cast<std::chrono::microseconds>(time).count()) + ' ';
  }
  record("picture" + takeErrors(), thrash.picture());
  record("times", {times.begin(), times.end()});
  screen.destroy(context);
  return 0;
}
