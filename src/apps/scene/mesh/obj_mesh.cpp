#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "apps/scene/mesh/obj.h"

namespace arbiter::scene {

namespace {

/// Returns the normalized vector, or `other` if its length is zero or not a finite float.
glm::vec3 unitOr(const glm::vec3 &vector, const glm::vec3 &other) {
  const float length = glm::length(vector);
  return length > 1e-30f && std::isfinite(length) ? vector / length : other;
}

/// Returns any direction perpendicular to a normal.
glm::vec3 across(const glm::vec3 &normal) {
  const glm::vec3 axis = std::abs(normal.x) < 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(axis - normal * glm::dot(axis, normal));
}

/// The direction in which s increases, in object coordinates, of a triangle or of all triangles
/// around a vertex, weighted by area.
struct Direction {
  glm::vec3 s{0.0f};
  bool mirrored = false; ///< (s, t) is clockwise on the surface
};

class Builder {
public:
  explicit Builder(const ObjFaces &faces) : m_faces(faces) {}

  Mesh run() {
    averageNormals();
    for (const auto &triangle : m_faces.triangles)
      addTriangle(triangle);
    for (std::size_t i = 0; i < m_mesh.vertices.size(); ++i)
      setTangent(m_mesh.vertices[i], m_directions[i]);
    return std::move(m_mesh);
  }

private:
  using Corner = ObjFaces::Corner;
  /// Distinguishes vertices. One with mirrored texture coordinates has another binormal than its
  /// neighbor.
  using Key = std::tuple<int, int, int, bool>;

  [[nodiscard]] const glm::vec3 &place(const Corner &corner) const {
    return m_faces.positions[std::size_t(corner.position)];
  }
  [[nodiscard]] glm::vec2 st(const Corner &corner) const {
    return corner.st < 0 ? glm::vec2(0.0f) : m_faces.sts[std::size_t(corner.st)];
  }

  [[nodiscard]] glm::vec3 faceOf(const std::array<Corner, 3> &triangle) const {
    return glm::cross(place(triangle[1]) - place(triangle[0]),
                      place(triangle[2]) - place(triangle[0]));
  }

  void averageNormals() {
    m_averages.assign(m_faces.positions.size(), glm::vec3(0.0f));
    for (const auto &triangle : m_faces.triangles)
      for (const Corner &corner : triangle)
        m_averages[std::size_t(corner.position)] += faceOf(triangle);
  }

  [[nodiscard]] glm::vec3 normalOf(const Corner &corner) const {
    const glm::vec3 average = unitOr(m_averages[std::size_t(corner.position)], {0, 0, 1});
    return corner.normal < 0 ? average
                             : unitOr(m_faces.normals[std::size_t(corner.normal)], average);
  }

  [[nodiscard]] Direction directionOf(const std::array<Corner, 3> &triangle) const {
    const glm::vec3 p = place(triangle[1]) - place(triangle[0]),
                    q = place(triangle[2]) - place(triangle[0]);
    const glm::vec2 u = st(triangle[1]) - st(triangle[0]), v = st(triangle[2]) - st(triangle[0]);
    const float turn = u.x * v.y - v.x * u.y;
    const float sign = turn < 0 ? -1.0f : turn > 0 ? 1.0f : 0.0f;
    return {(p * v.y - q * u.y) * sign, turn < 0};
  }

  void addTriangle(const std::array<Corner, 3> &triangle) {
    const Direction direction = directionOf(triangle);
    for (const Corner &corner : triangle) {
      const std::uint32_t index = vertexOf(corner, direction.mirrored);
      m_directions[index].s += direction.s;
      m_mesh.indices.push_back(index);
    }
  }

  std::uint32_t vertexOf(const Corner &corner, bool mirrored) {
    const auto [found, isNew] =
        m_numbers.try_emplace(Key(corner.position, corner.st, corner.normal, mirrored),
                              std::uint32_t(m_mesh.vertices.size()));
    if (isNew) {
      MeshVertex &vertex = m_mesh.vertices.emplace_back();
      vertex.position = place(corner);
      vertex.normal = normalOf(corner);
      vertex.st = st(corner);
      m_directions.emplace_back().mirrored = mirrored;
    }
    return found->second;
  }

  static void setTangent(MeshVertex &vertex, const Direction &direction) {
    const glm::vec3 flat = direction.s - vertex.normal * glm::dot(vertex.normal, direction.s);
    vertex.tangent =
        glm::vec4(unitOr(flat, across(vertex.normal)), direction.mirrored ? -1.0f : 1.0f);
  }

  const ObjFaces &m_faces;
  std::vector<glm::vec3> m_averages; ///< of each position, not normalized
  std::map<Key, std::uint32_t> m_numbers;
  std::vector<Direction> m_directions; ///< of each vertex
  Mesh m_mesh;
};

} // namespace

Mesh meshOf(const ObjFaces &faces) { return Builder(faces).run(); }

} // namespace arbiter::scene
