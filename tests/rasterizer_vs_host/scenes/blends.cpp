// Draws blended pictures: rasterizer-blends. It tests each pair of factors, each equation, and
// separate factors for alpha, in a window and in a texture without alpha, with random colors. The
// last picture is a stack of many faint layers.
#include <cstdlib>
#include <initializer_list>

#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 64;

constexpr GLenum kFactors[] = {
    GL_ZERO,
    GL_ONE,
    GL_SRC_COLOR,
    GL_ONE_MINUS_SRC_COLOR,
    GL_SRC_ALPHA,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_DST_ALPHA,
    GL_ONE_MINUS_DST_ALPHA,
    GL_DST_COLOR,
    GL_ONE_MINUS_DST_COLOR,
    GL_CONSTANT_COLOR,
    GL_ONE_MINUS_CONSTANT_COLOR,
    GL_CONSTANT_ALPHA,
    GL_ONE_MINUS_CONSTANT_ALPHA,
    GL_SRC_ALPHA_SATURATE,
};
constexpr GLenum kEquations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN,
                                 GL_MAX};

/// Fills the target with random pixels.
void fillByChance(Random &random) {
  glDisable(GL_BLEND);
  std::vector<unsigned char> pixels(std::size_t(kEdge) * kEdge * 4);
  for (unsigned char &byte : pixels)
    byte = static_cast<unsigned char>(random.bits());
  glRasterPos2f(-1, -1);
  glDrawPixels(kEdge, kEdge, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

/// Blends squares of 8 pixels, each of one random color.
void blendByChance(Random &random) {
  glEnable(GL_BLEND);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const auto byte = [&] { return static_cast<GLubyte>(random.bits()); };
      glColor4ub(byte(), byte(), byte(), byte());
      glRectf(float(x) / 4 - 1, float(y) / 4 - 1, float(x + 1) / 4 - 1, float(y + 1) / 4 - 1);
    }
}

void picture(const std::string &name, Random &random) {
  fillByChance(random);
  blendByChance(random);
  record(name, readRgba(0, 0, kEdge, kEdge));
}

void pictures(const std::string &target) {
  Random random(47);
  glViewport(0, 0, kEdge, kEdge);
  for (const GLenum source : kFactors)
    for (const GLenum dest : kFactors) {
      glBlendColor(random.real(-0.1f, 1.1f), random.real(0, 1), 0.5f, random.real(0, 1));
      glBlendEquation(GL_FUNC_ADD);
      glBlendFunc(source, dest);
      picture(target + " factors " + std::to_string(source) + " " + std::to_string(dest), random);
    }
  for (const GLenum color : kEquations)
    for (const GLenum alpha : kEquations) {
      glBlendEquationSeparate(color, alpha);
      glBlendFuncSeparate(random.pick(kFactors), random.pick(kFactors), random.pick(kFactors),
                          random.pick(kFactors));
      picture(target + " equations " + std::to_string(color) + " " + std::to_string(alpha), random);
    }
}

/// Draws layers like many programs' glows: each adds less than a step of the buffer.
void layers() {
  glDisable(GL_BLEND);
  glClearColor(0, 0.9f, 0.25f, 0.5f);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (int i = 0; i < 40; ++i) {
    glColor4ub(50, 180, 255, GLubyte(1 + i % 5));
    glRectf(-1, -1, 1, 1);
  }
  record("40 layers", readRgba(0, 0, kEdge, kEdge));
}

} // namespace
} // namespace software

int main() {
  using namespace software;
  software::Screen screen; // Xlib has a Screen too
  if (!screen.open())
    return 1;
  screen.makeCurrent(screen.makeWindow(kEdge, kEdge), screen.makeContext());
  glDisable(GL_DITHER);
  glClear(GL_COLOR_BUFFER_BIT);
  pictures("window");
  layers();
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, kEdge, kEdge, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  makeFramebuffer(texture);
  pictures("texture");
  record("errors" + takeErrors(), {});
  return 0;
}
