#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "apps/scene/mesh/obj.h"

namespace arbiter::scene {

namespace {

/// Computes the normal by Newell's method: twice the area along each axis, for any order of
/// corners.
glm::vec3 normalOf(const std::vector<glm::vec3> &corners) {
  glm::vec3 normal(0.0f);
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += glm::cross(corners[i], corners[(i + 1) % corners.size()]);
  return normal;
}

float area(const glm::vec2 &a, const glm::vec2 &b, const glm::vec2 &c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Triangulates by ear clipping: it cuts off corners whose triangle contains no other corner.
class Cutter {
public:
  explicit Cutter(const std::vector<glm::vec3> &corners) : m_ring(corners.size()) {
    std::iota(m_ring.begin(), m_ring.end(), std::size_t(0));
    flatten(corners);
  }

  std::vector<std::array<std::size_t, 3>> run() {
    while (m_ring.size() > 3)
      cut(ear());
    cut(1);
    return std::move(m_triangles);
  }

private:
  /// Projects the polygon along the axis in which its area is greatest, so that it is
  /// counter-clockwise.
  void flatten(const std::vector<glm::vec3> &corners) {
    const glm::vec3 normal = normalOf(corners), size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const bool turned = normal[axis] < 0;
    const int u = (axis + (turned ? 2 : 1)) % 3, v = (axis + (turned ? 1 : 2)) % 3;
    for (const glm::vec3 &corner : corners)
      m_points.emplace_back(corner[u], corner[v]);
  }

  [[nodiscard]] const glm::vec2 &point(std::size_t place) const {
    return m_points[m_ring[place % m_ring.size()]];
  }

  [[nodiscard]] bool isEar(std::size_t at) const {
    const std::size_t count = m_ring.size();
    const glm::vec2 &a = point(at + count - 1), &b = point(at), &c = point(at + 1);
    if (area(a, b, c) <= 0)
      return false;
    for (std::size_t i = at + 2; i < at + count - 1; ++i) {
      const glm::vec2 &other = point(i);
      if (other != a && other != b && other != c && area(a, b, other) >= 0 &&
          area(b, c, other) >= 0 && area(c, a, other) >= 0)
        return false;
    }
    return true;
  }

  /// Returns an ear. A self-intersecting polygon has no right answer; any corner then serves, so
  /// that the loop ends.
  [[nodiscard]] std::size_t ear() const {
    for (std::size_t at = 1; at <= m_ring.size(); ++at)
      if (isEar(at % m_ring.size()))
        return at % m_ring.size();
    return 1;
  }

  void cut(std::size_t at) {
    const std::size_t count = m_ring.size();
    m_triangles.push_back({m_ring[(at + count - 1) % count], m_ring[at], m_ring[(at + 1) % count]});
    m_ring.erase(m_ring.begin() + std::ptrdiff_t(at));
  }

  std::vector<std::size_t> m_ring; ///< the remaining corners
  std::vector<glm::vec2> m_points;
  std::vector<std::array<std::size_t, 3>> m_triangles;
};

} // namespace

std::vector<std::array<std::size_t, 3>> cutPolygon(const std::vector<glm::vec3> &corners) {
  return corners.size() < 3 ? std::vector<std::array<std::size_t, 3>>() : Cutter(corners).run();
}

} // namespace arbiter::scene
