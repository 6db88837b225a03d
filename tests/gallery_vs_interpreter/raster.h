#pragma once
#include <array>
#include <functional>
#include <glm/vec4.hpp>
#include <vector>

/// Rasterizes triangles in plain C++ as GL specifies (window coordinates with 8 subpixel bits, each
/// shared edge drawn once, perspective-correct values), for comparison with GL's pictures.
namespace gallery {

inline constexpr std::size_t kVaryings = 9; ///< texture coordinates 0 to 7 and the primary color
inline constexpr std::size_t kColor = 8;

struct Vertex {
  glm::dvec4 clip{0.0};
  std::array<glm::vec4, kVaryings> varyings = {};
};

struct Fragment {
  int x = 0, y = 0;
  double depth = 0; ///< window z, [0,1]
  double inverseW = 1;
  bool front = true; ///< true for a counter-clockwise triangle
  std::array<glm::vec4, kVaryings> varyings = {};
};

using Shade = std::function<void(const Fragment &)>;

/// Clips to the near and far plane and to w > 0, and to the picture's sides.
/// \param used the varyings to interpolate
void rasterize(const Vertex &a, const Vertex &b, const Vertex &c, int width, int height,
               const std::array<bool, kVaryings> &used, const Shade &shade);

} // namespace gallery
