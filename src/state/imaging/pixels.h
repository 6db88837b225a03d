#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace arbiter::state::imaging {

/// The components of a pixel: red, green, blue, alpha.
using Rgba = std::array<float, 4>;

/// An image of RGBA pixels, bottom row first.
struct Pixels {
  int width = 0, height = 1, depth = 1;
  std::vector<Rgba> texels;

  [[nodiscard]] std::size_t count() const {
    return std::size_t(width) * std::size_t(height) * std::size_t(depth);
  }
  [[nodiscard]] const Rgba &at(int x, int y) const {
    return texels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

} // namespace arbiter::state::imaging
