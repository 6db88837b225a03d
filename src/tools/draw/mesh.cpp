#include "tools/draw/mesh.h"

#include <cmath>
#include <numbers>

namespace arbiter::tools {

namespace {

constexpr int kParts = 64; ///< a side; a power of two, so that coordinates are exact

MeshVertex onQuad(float s, float t) { return {{2 * s - 1, 2 * t - 1, 0}, {0, 0, 1}, s, t}; }

/// s goes once around from the back, t from the south pole to the north.
MeshVertex onSphere(float s, float t) {
  const float around = 2 * std::numbers::pi_v<float> * s, up = std::numbers::pi_v<float> * t;
  const std::array<float, 3> point = {-std::sin(up) * std::sin(around), -std::cos(up),
                                      -std::sin(up) * std::cos(around)};
  return {point, point, s, t};
}

} // namespace

std::vector<MeshVertex> quadsOf(Mesh mesh) {
  const int parts = mesh == Mesh::Quad ? 1 : kParts;
  const auto at = [&](int x, int y) {
    const float s = float(x) / float(parts), t = float(y) / float(parts);
    return mesh == Mesh::Sphere ? onSphere(s, t) : onQuad(s, t);
  };
  std::vector<MeshVertex> vertices;
  for (int y = 0; y < parts; ++y)
    for (int x = 0; x < parts; ++x)
      for (const auto &[dx, dy] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
        vertices.push_back(at(x + dx, y + dy));
  return vertices;
}

} // namespace arbiter::tools
