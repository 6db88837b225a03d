#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "apps/scene/panel/panel.h"
#include "util/result.h"

namespace arbiter::scene {

struct MeshVertex {
  glm::vec3 position{0.0f}; ///< object coordinates
  glm::vec3 normal{0.0f, 0.0f, 1.0f};
  /// The direction in which s increases; binormal = cross(normal, tangent) * w.
  glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f};
  glm::vec2 st{0.0f};
  glm::vec4 extra{0.0f, 0.0f, 0.0f, 1.0f}; ///< depends on the shape; its row in words.def says how

  [[nodiscard]] glm::vec3 binormal() const;
};

/// A mesh of triangles, counter-clockwise seen from outside.
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices; ///< three for each triangle
};

struct MeshError {
  fp::Span span; ///< of the shape's word
  std::string message;
};

inline constexpr double kMaxVertices = 2097152;

/// Builds the shapes, each scaled and moved to its place, into one mesh. Without a shape it is a
/// quad.
/// \param folder the document's folder, where its files are; ends with a slash, or is empty. An
///        absolute name, which a panel never has, is used as it is.
[[nodiscard]] Result<Mesh, MeshError> buildMesh(const std::vector<ShapeSpec> &shapes,
                                                const std::string &folder);

/// Returns the texture coordinates of a set, computed from the vertex.
[[nodiscard]] glm::vec4 coordinateOf(const MeshVertex &vertex, const CoordinateSpec &spec);

} // namespace arbiter::scene
