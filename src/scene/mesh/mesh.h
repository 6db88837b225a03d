#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "scene/panel/panel.h"
#include "util/result.h"

namespace arbiter::scene {

struct MeshVertex {
  glm::vec3 position{0.0f}; ///< object coordinates
  glm::vec3 normal{0.0f, 0.0f, 1.0f};
  /// The direction in which s grows; binormal = cross(normal, tangent) * w.
  glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f};
  glm::vec2 st{0.0f};
  glm::vec4 extra{0.0f, 0.0f, 0.0f, 1.0f}; ///< by the shape: its row in words.def says what

  [[nodiscard]] glm::vec3 binormal() const;
};

/// Triangles, counter-clockwise seen from outside.
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices; ///< three a triangle
};

struct MeshError {
  fp::Span span; ///< of the shape's word
  std::string message;
};

inline constexpr double kMaxVertices = 2097152;

/// Shapes one after another, each scaled and moved to its place. No shape at all: a quad.
/// \param folder of the document, where its files are; with a slash behind it, or empty. An
/// absolute
///        name, which a panel never has, is taken as it is.
[[nodiscard]] Result<Mesh, MeshError> buildMesh(const std::vector<ShapeSpec> &shapes,
                                                const std::string &folder);

/// Texture coordinates of a set, from what the vertex has.
[[nodiscard]] glm::vec4 coordinateOf(const MeshVertex &vertex, const CoordinateSpec &spec);

} // namespace arbiter::scene
