// Draws a plane with a detailed texture at steep angles: rasterizer-anisotropy. Each view is drawn
// without anisotropy and with 2, 4, 8 and 16 to 1, and also computed as the mean of 16 times 16
// samples of the texture a pixel. Writes all pictures as records, which anisotropy.py judges.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 128;      // of the pictures
constexpr int kTexels = 512;    // of the texture
constexpr int kSamples = 16;    // of the reference, in x and in y
constexpr double kFinest = 1.6; // width of a pixel in the middle of a picture, in texels

/// One level of RGB texels, alpha 255.
using Texels = std::vector<unsigned char>;

/// Makes squares of several sizes, lines, and a grain of single texels.
Texels makeTexels(Random &random) {
  Texels texels;
  for (int y = 0; y < kTexels; ++y)
    for (int x = 0; x < kTexels; ++x) {
      const bool square = ((x >> 5) + (y >> 5)) % 2 != 0, small = ((x >> 2) ^ (y >> 3)) % 2 != 0;
      const bool line = x % 24 == 0 || y % 40 < 2;
      const int grain = random.below(64);
      texels.push_back((unsigned char)(line ? 250 : (square ? 150 : 40) + grain));
      texels.push_back((unsigned char)(line ? 20 : (small ? 170 : 30) + grain));
      texels.push_back((unsigned char)(line ? 20 : 3 * grain));
      texels.push_back(255);
    }
  return texels;
}

Texels halved(const Texels &from, int size) {
  Texels to;
  for (int y = 0; y < size; y += 2)
    for (int x = 0; x < size; x += 2)
      for (int c = 0; c < 4; ++c) {
        const auto at = [&](int dx, int dy) {
          return int(from[std::size_t(((y + dy) * size + x + dx) * 4 + c)]);
        };
        to.push_back((unsigned char)((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1) + 2) / 4));
      }
  return to;
}

/// A camera above a plane. Points of the picture are (x, y) in [-1, 1].
class View {
public:
  /// Makes a view by angles in degrees: \param elevation of the middle ray over the plane
  /// \param turn of the texture on the plane \param roll of the camera about the middle ray
  View(double elevation, double turn, double roll)
      : m_sin(std::sin(radians(elevation))), m_cos(std::cos(radians(elevation))),
        m_zoom(0.5 * std::min(m_sin / m_cos, 2.0)), m_turn(radians(turn)), m_roll(radians(roll)) {
    // At the middle of the picture a pixel's width is 2 * zoom / edge of its distance 1 / sin.
    m_texelsPerUnit = kFinest / (2 * m_zoom / kEdge / m_sin);
  }
  /// Returns 1 / w of the vertex there.
  [[nodiscard]] double depth(double x, double y) const {
    return m_sin - rolled(x, y)[1] * m_zoom * m_cos;
  }
  /// Returns the texture coordinates there.
  [[nodiscard]] std::array<double, 2> coordinate(double x, double y) const {
    const double scale = m_texelsPerUnit / kTexels / depth(x, y);
    const auto [across, up] = rolled(x, y);
    const double side = across * m_zoom * scale, ahead = (m_cos + up * m_zoom * m_sin) * scale;
    return {std::cos(m_turn) * side - std::sin(m_turn) * ahead,
            std::sin(m_turn) * side + std::cos(m_turn) * ahead};
  }

private:
  static double radians(double degrees) { return degrees * std::numbers::pi / 180; }
  [[nodiscard]] std::array<double, 2> rolled(double x, double y) const {
    return {std::cos(m_roll) * x - std::sin(m_roll) * y,
            std::sin(m_roll) * x + std::cos(m_roll) * y};
  }
  double m_sin, m_cos, m_zoom, m_turn, m_roll, m_texelsPerUnit = 1;
};

/// Samples the base level with a linear filter, repeated.
std::array<double, 3> linear(const Texels &texels, const std::array<double, 2> &at) {
  const double u = at[0] * kTexels - 0.5, v = at[1] * kTexels - 0.5;
  const double x = std::floor(u), y = std::floor(v);
  std::array<double, 3> sum = {};
  for (int corner = 0; corner < 4; ++corner) {
    const int dx = corner % 2, dy = corner / 2;
    const double weight = (dx ? u - x : 1 - (u - x)) * (dy ? v - y : 1 - (v - y));
    const auto column = std::size_t((long(x) + dx) & (kTexels - 1)),
               row = std::size_t((long(y) + dy) & (kTexels - 1));
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += weight * texels[(row * kTexels + column) * 4 + c];
  }
  return sum;
}

std::vector<unsigned char> supersampled(const Texels &texels, const View &view) {
  std::vector<unsigned char> picture;
  const auto point = [](int pixel, int sample) {
    return 2 * (pixel + (sample + 0.5) / kSamples) / kEdge - 1;
  };
  for (int y = 0; y < kEdge; ++y)
    for (int x = 0; x < kEdge; ++x) {
      std::array<double, 3> sum = {};
      for (int i = 0; i < kSamples * kSamples; ++i) {
        const auto color =
            linear(texels, view.coordinate(point(x, i % kSamples), point(y, i / kSamples)));
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += color[c];
      }
      for (const double component : sum)
        picture.push_back((unsigned char)std::lround(component / (kSamples * kSamples)));
      picture.push_back(255);
    }
  return picture;
}

void draw(const View &view) {
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 4; ++i) {
    const int right = i % 2, upper = i / 2;
    const double x = 2 * right - 1, y = 2 * upper - 1, w = 1 / view.depth(x, y);
    const auto at = view.coordinate(x, y);
    glTexCoord2d(at[0], at[1]);
    glVertex4d(x * w, y * w, 0, w);
  }
  glEnd();
}

Texels makeTexture() {
  Random random(5);
  Texels base = makeTexels(random);
  Texels level = base;
  for (int size = kTexels, number = 0; size > 0; size /= 2, ++number) {
    glTexImage2D(GL_TEXTURE_2D, number, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 level.data());
    if (size > 1)
      level = halved(level, size);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  return base;
}

void drawView(const Texels &texels, int elevation, int turn, int roll) {
  const View view(elevation, turn, roll);
  char name[64];
  std::snprintf(name, sizeof name, "%2d degrees, turned %2d, rolled %2d", elevation, turn, roll);
  record(std::string(name) + ": reference", supersampled(texels, view));
  for (const int most : {1, 2, 4, 8, 16}) {
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, float(most));
    draw(view);
    record(std::string(name) + ": " + std::to_string(most) + takeErrors(),
           readRgba(0, 0, kEdge, kEdge));
  }
}

} // namespace
} // namespace software

int main() {
  using namespace software;
  software::Screen screen; // X11 has a Screen too
  if (!screen.open())
    return 1;
  const GLXContext context = screen.makeContext();
  screen.makeCurrent(screen.makePbuffer(kEdge, kEdge), context);
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                    "!!ARBfp1.0\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND\n");
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glDisable(GL_DITHER);
  glViewport(0, 0, kEdge, kEdge);
  const Texels texels = makeTexture();
  for (const int elevation : {90, 60, 30, 15, 7, 4})
    for (const int turn : {0, 25})
      for (const int roll : {0, 40})
        drawView(texels, elevation, turn, roll);
  screen.destroy(context);
  return 0;
}
