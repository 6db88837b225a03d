#pragma once
#include <array>
#include <functional>
#include <glm/vec4.hpp>
#include <vector>

/// Triangles to fragments in plain C++, as GL says it (window coordinates of 8 subpixel bits, each
/// shared edge drawn once, perspective-correct values), to compare GL's pictures with.
namespace gallery {

inline constexpr std::size_t kVaryings = 9; ///< texture coordinates 0 to 7, primary colour
inline constexpr std::size_t kColour = 8;

struct Vertex {
  glm::dvec4 clip{0.0};
  std::array<glm::vec4, kVaryings> varyings = {};
};

struct Fragment {
  int x = 0, y = 0;
  double depth = 0; ///< window z, [0,1]
  double inverseW = 1;
  bool front = true; ///< of a counter-clockwise triangle
  std::array<glm::vec4, kVaryings> varyings = {};
};

using Shade = std::function<void(const Fragment &)>;

/// Clips to the near and the far plane and to w > 0; the sides are the picture's.
/// \param used varyings that are worth interpolating
void rasterize(const Vertex &a, const Vertex &b, const Vertex &c, int width, int height,
               const std::array<bool, kVaryings> &used, const Shade &shade);

} // namespace gallery
