#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace demos {

/// An 8-bit RGBA picture. Row 0 is the bottom one, as in GL.
struct Image {
  Image() = default;
  Image(int columns, int rows) : width(columns), height(rows), bytes(4ull * columns * rows) {}

  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;

  /// Returns a pixel in [0,1].
  [[nodiscard]] glm::vec4 at(int x, int y) const;
  /// Stores a color as a framebuffer does: clamped to [0,1], rounded to the nearest of 256 levels.
  void set(int x, int y, const glm::vec4 &color);
  /// Returns the texel center of (x, y) as a texture coordinate.
  [[nodiscard]] glm::vec2 coordinate(int x, int y) const {
    return {(float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height)};
  }
  /// Samples with GL_LINEAR and GL_CLAMP_TO_EDGE.
  [[nodiscard]] glm::vec4 sampleLinear(glm::vec2 coordinate) const;
};

/// The allowed difference between two pictures, in levels of 255, and the fraction of pixels that
/// may exceed it.
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

/// Compares red, green and blue, as a window need not have alpha.
[[nodiscard]] Difference compare(const Image &picture, const Image &reference, Tolerance tolerance);

/// Writes an RGB PNG. On failure it prints the reason on stderr and returns false.
[[nodiscard]] bool writePng(const Image &image, const std::string &file);

} // namespace demos
