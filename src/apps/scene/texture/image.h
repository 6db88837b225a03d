#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "apps/scene/picture.h"

namespace arbiter::scene {

/// An RGBA image of 8 or 16 bits a component. Row 0 is the bottom one, as in GL.
struct Image {
  Image() = default;
  Image(int columns, int rows, int componentBits = 8)
      : width(columns), height(rows), bits(componentBits),
        texels(std::size_t(4) * std::size_t(columns) * std::size_t(rows)) {}
  explicit Image(const Picture &picture);

  int width = 0;
  int height = 0;
  int bits = 8;
  std::vector<std::uint16_t> texels; ///< 0 to most()
  std::vector<Image> smaller;        ///< levels 1 and up, if the file has them

  [[nodiscard]] float most() const { return bits == 16 ? 65535.0f : 255.0f; }
  /// Returns a texel in [0,1].
  [[nodiscard]] glm::vec4 at(int x, int y) const;
  /// Sets a texel: clamps to [0,1] and rounds to the nearest level.
  void set(int x, int y, const glm::vec4 &color);
  /// Returns the middle of a texel as a texture coordinate.
  [[nodiscard]] glm::vec2 coordinate(int x, int y) const {
    return {(float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height)};
  }
  /// Returns the image in 8 bits, as a thumbnail shows it.
  [[nodiscard]] Picture picture() const;
};

} // namespace arbiter::scene
