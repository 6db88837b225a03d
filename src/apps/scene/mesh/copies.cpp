// Meshes that are derived from another mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "apps/scene/mesh/shapes.h"

namespace arbiter::scene {

namespace {

using Place = std::array<long, 3>;

/// Rounds a position. Vertices at one position are one corner of the body, even if their texture
/// coordinates differ: a sphere's seam has two vertices for each corner.
Place placeOf(const glm::vec3 &position) {
  constexpr float kSteps = 8192; // a unit
  return {std::lround(position.x * kSteps), std::lround(position.y * kSteps),
          std::lround(position.z * kSteps)};
}

class FinBuilder {
public:
  FinBuilder(const Mesh &mesh, int parts) : m_mesh(mesh), m_parts(std::uint32_t(parts)) {}

  Mesh run() {
    for (std::size_t i = 0; i < m_mesh.indices.size(); ++i) {
      const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
      add(m_mesh.vertices[m_mesh.indices[i]], m_mesh.vertices[m_mesh.indices[next]]);
    }
    return std::move(m_fins);
  }

private:
  /// Adds the fin of an edge. Faces share edges, and each edge has one fin.
  void add(const MeshVertex &a, const MeshVertex &b) {
    const Place from = placeOf(a.position), to = placeOf(b.position);
    if (from == to || !m_edges.insert(std::minmax(from, to)).second)
      return;
    const auto first = std::uint32_t(m_fins.vertices.size());
    for (std::uint32_t layer = 0; layer <= m_parts; ++layer)
      for (const MeshVertex *const end : {&a, &b}) {
        m_fins.vertices.push_back(*end);
        m_fins.vertices.back().extra = {float(layer) / float(m_parts), end == &b ? 1.0f : 0.0f, 0,
                                        1};
      }
    for (std::uint32_t layer = 0; layer < m_parts; ++layer)
      for (const std::uint32_t corner : {0, 1, 3, 0, 3, 2})
        m_fins.indices.push_back(first + 2 * layer + corner);
  }

  const Mesh &m_mesh;
  const std::uint32_t m_parts;
  Mesh m_fins;
  std::set<std::pair<Place, Place>> m_edges;
};

class VolumeBuilder {
public:
  explicit VolumeBuilder(const Mesh &mesh) : m_mesh(mesh) {}

  Mesh run() {
    for (std::size_t i = 0; i < m_mesh.indices.size(); i += 3)
      addFace(i);
    for (const auto &[ends, edge] : m_edges)
      if (const auto other = m_edges.find({ends.second, ends.first});
          other != m_edges.end() && ends.first < ends.second)
        addQuad(edge, other->second);
    return std::move(m_volume);
  }

private:
  /// The numbers of an edge's vertices in the volume, in the face's order.
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  void addFace(std::size_t index) {
    std::array<MeshVertex, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = m_mesh.vertices[m_mesh.indices[index + i]];
    const glm::vec3 normal = glm::cross(corners[1].position - corners[0].position,
                                        corners[2].position - corners[0].position);
    if (glm::length(normal) < 1e-12f)
      return;
    const auto first = std::uint32_t(m_volume.vertices.size());
    for (MeshVertex &corner : corners) {
      corner.normal = glm::normalize(normal);
      m_volume.vertices.push_back(corner);
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t next = (i + 1) % 3;
      m_volume.indices.push_back(first + i);
      m_edges.insert({{placeOf(corners[i].position), placeOf(corners[next].position)},
                      {first + i, first + next}});
    }
  }

  /// Adds the quad between two faces. \p one goes from p to q, \p other from q to p.
  void addQuad(const Edge &one, const Edge &other) {
    const auto [p1, q1] = one;
    const auto [q2, p2] = other;
    for (const std::uint32_t index : {q1, p1, p2, q1, p2, q2})
      m_volume.indices.push_back(index);
  }

  const Mesh &m_mesh;
  Mesh m_volume;
  std::map<std::pair<Place, Place>, Edge> m_edges;
};

} // namespace

Mesh makeShells(const Mesh &mesh, int count) {
  Mesh shells;
  for (int layer = 0; layer < count; ++layer) {
    for (const std::uint32_t index : mesh.indices)
      shells.indices.push_back(index + std::uint32_t(shells.vertices.size()));
    const float height = count == 1 ? 0.0f : float(layer) / float(count - 1);
    const std::size_t first = shells.vertices.size();
    shells.vertices.insert(shells.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (std::size_t i = first; i < shells.vertices.size(); ++i)
      shells.vertices[i].extra = {height, 0, 0, 1};
  }
  return shells;
}

Mesh makeFins(const Mesh &mesh, int parts) { return FinBuilder(mesh, parts).run(); }

Mesh makeVolume(const Mesh &mesh) { return VolumeBuilder(mesh).run(); }

} // namespace arbiter::scene
