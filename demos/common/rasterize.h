#pragma once
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace demos {

/// A vertex after transformation: clip coordinates and two vec3 varyings.
struct RasterVertex {
  glm::vec4 clip;
  glm::vec3 varyings[2];
};

/// Rasterizes triangles as GL does (top-left rule, window coordinates with 8 subpixel bits, depth
/// test LESS, perspective-correct varyings), for comparison with a GL picture. It does not clip:
/// every vertex must lie inside the view volume.
class Rasterizer {
public:
  using Shader = std::function<void(int x, int y, const glm::vec3 (&varyings)[2])>;

  Rasterizer(int width, int height) : m_width(width), m_height(height), m_depth(area(), 1.0) {}
  /// Calls \p shader for each fragment that passes the depth test.
  void triangle(const RasterVertex &a, const RasterVertex &b, const RasterVertex &c,
                const Shader &shader);

private:
  [[nodiscard]] std::size_t area() const { return std::size_t(m_width) * std::size_t(m_height); }

  int m_width;
  int m_height;
  std::vector<double> m_depth;
};

} // namespace demos
