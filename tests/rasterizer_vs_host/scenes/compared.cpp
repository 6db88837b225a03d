// Draws fixed function with depth comparison textures: rasterizer-compared SEED COUNT. There is a
// picture for each target and depth format, with a cell for each TEXTURE_COMPARE_FUNC and filter;
// depth texture modes and environments alternate. The references of a cell go from below 0 to above
// 1. Writes pictures as records, which comparisons.py compares. There are two pictures for 1D
// textures, one with t equal to r: OpenGL compares r (1.4, 3.8.14), Mesa 22.3.6 t.
#include <cstdlib>

#include "surface.h"

namespace software {
namespace {

constexpr int kCell = 8; // texels and pixels of its side
constexpr int kFunctions = 8, kFilters = 2;
constexpr int kEdge = kCell * kFunctions;

struct Named {
  GLenum value;
  const char *name;
  bool tIsR = false;
};
constexpr Named kTargets[] = {{GL_TEXTURE_1D, "1D", true},
                              {GL_TEXTURE_1D, "1D, t is another"},
                              {GL_TEXTURE_2D, "2D"},
                              {GL_TEXTURE_RECTANGLE, "rectangle"}};
constexpr Named kFormats[] = {{GL_DEPTH_COMPONENT16, "16"},
                              {GL_DEPTH_COMPONENT24, "24"},
                              {GL_DEPTH_COMPONENT32, "32"},
                              {GL_DEPTH_COMPONENT32F, "32F"},
                              {GL_DEPTH24_STENCIL8, "24 and 8"}};
constexpr GLint kEnvironments[] = {GL_REPLACE, GL_MODULATE, GL_BLEND, GL_ADD};
constexpr GLint kModes[] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA, GL_RED};

/// Sets random 32-bit depths. A third are 0 or 1, which a clamped reference equals.
void setImage(Random &random, GLenum target, GLenum format) {
  std::vector<std::uint32_t> texels(std::size_t(kCell) * kCell);
  for (std::uint32_t &texel : texels)
    texel =
        random.once(3) ? (random.once(2) ? ~std::uint32_t(0) : 0) : std::uint32_t(random.bits());
  const bool packed = format == GL_DEPTH24_STENCIL8;
  const GLenum order = packed ? GLenum(GL_DEPTH_STENCIL) : GLenum(GL_DEPTH_COMPONENT);
  const GLenum type = packed ? GLenum(GL_UNSIGNED_INT_24_8) : GLenum(GL_UNSIGNED_INT);
  if (target == GL_TEXTURE_1D)
    glTexImage1D(target, 0, GLint(format), kCell, 0, order, type, texels.data());
  else
    glTexImage2D(target, 0, GLint(format), kCell, kCell, 0, order, type, texels.data());
}

/// Draws a texel for each pixel; with linear filters off center, so that two or four texels count.
void drawCell(const Named &target, int function, bool linear, bool projected) {
  const float x = float(kCell * function), y = linear ? kCell : 0;
  const float size = target.value == GL_TEXTURE_RECTANGLE ? kCell : 1;
  const float off = linear ? 0.2f / kCell : 0, q = projected ? 2 : 1;
  glBegin(GL_QUADS);
  for (int i = 0; i < 4; ++i) {
    const auto right = float(i == 1 || i == 2), top = float(i >= 2);
    const float r = 0.73f * right + 0.77f * top - 0.25f;
    glTexCoord4f(q * size * (right + off), q * (target.tIsR ? r : size * (top + off)), q * r, q);
    glVertex2f(x + kCell * right, y + kCell * top);
  }
  glEnd();
}

void drawPicture(const std::string &name, Random &random, const Named &target, const Named &format,
                 int number) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(target.value, texture);
  setImage(random, target.value, format.value);
  glTexParameteri(target.value, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target.value, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(target.value, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  glEnable(target.value);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, kEnvironments[number % 4]);
  const float constant[4] = {0.5f, 0.25f, 0.75f, 0.375f};
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
  glClear(GL_COLOR_BUFFER_BIT);
  glColor4f(0.75f, 0.5f, 0.25f, 0.625f);
  for (int cell = 0; cell < kFunctions * kFilters; ++cell) {
    const int function = cell % kFunctions;
    const bool linear = cell >= kFunctions;
    glTexParameteri(target.value, GL_TEXTURE_COMPARE_FUNC, GL_NEVER + function);
    glTexParameteri(target.value, GL_DEPTH_TEXTURE_MODE,
                    kModes[(cell + cell / 4 + number / 4) % 4]);
    glTexParameteri(target.value, GL_TEXTURE_MIN_FILTER, linear ? GL_LINEAR : GL_NEAREST);
    glTexParameteri(target.value, GL_TEXTURE_MAG_FILTER, linear ? GL_LINEAR : GL_NEAREST);
    drawCell(target, function, linear, number % 2 == 0);
  }
  record(name + ", " + target.name + ", " + format.name + takeErrors(),
         readRgba(0, 0, kEdge, kCell * kFilters));
  glDisable(target.value);
  glDeleteTextures(1, &texture);
}

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  return drawSeeds(
      argc, argv, kEdge, nullptr, [](int seed, software::Screen &screen, GLXDrawable window, bool) {
        const GLXContext context = screen.makeContext();
        screen.makeCurrent(window, context);
        glViewport(0, 0, kEdge, kEdge);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glOrtho(0, kEdge, 0, kEdge, -1, 1);
        glDisable(GL_DITHER);
        glClearColor(0.25f, 0.5f, 0.125f, 0.5f);
        for (const Named &target : kTargets)
          for (const Named &format : kFormats) {
            const int number = seed + int(&format - kFormats);
            Random random{std::uint64_t(seed)}; // the same texels for each target
            drawPicture("seed " + std::to_string(seed), random, target, format, number);
            screen.swap(window);
          }
        screen.destroy(context);
      });
}
