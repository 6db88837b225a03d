#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace demos {

/// An 8-bit RGBA picture; row 0 is the bottom one, as in GL.
struct Image {
  Image() = default;
  Image(int columns, int rows) : width(columns), height(rows), bytes(4ull * columns * rows) {}

  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;

  /// A pixel in [0,1].
  [[nodiscard]] glm::vec4 at(int x, int y) const;
  /// Stores a colour as a framebuffer does: clamped to [0,1], rounded to the nearest of 256 levels.
  void set(int x, int y, const glm::vec4 &colour);
  /// The texel centre of (x, y) as a texture coordinate.
  [[nodiscard]] glm::vec2 coordinate(int x, int y) const {
    return {(float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height)};
  }
  /// GL_LINEAR with GL_CLAMP_TO_EDGE.
  [[nodiscard]] glm::vec4 sampleLinear(glm::vec2 coordinate) const;
};

/// How far two pictures may be apart, in levels of 255, and in pixels that may be further apart.
struct Tolerance {
  int levels = 0;
  double outliers = 0; ///< fraction of the pixels, for silhouettes
};

struct Difference {
  int maxError = 0;       ///< levels, over red, green and blue
  std::size_t beyond = 0; ///< pixels beyond Tolerance::levels
  glm::ivec2 worst{0, 0};
  bool ok = false;
};

/// Compares red, green and blue; a window need not have alpha.
[[nodiscard]] Difference compare(const Image &picture, const Image &reference, Tolerance tolerance);

/// Writes an RGB PNG; says on stderr what went wrong and returns false if it cannot.
[[nodiscard]] bool writePng(const Image &image, const std::string &file);

} // namespace demos
