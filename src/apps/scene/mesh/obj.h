#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "apps/scene/mesh/mesh.h"
#include "util/result.h"

/// Reads meshes from OBJ files. The files are untrusted: every index and every count is checked.
namespace arbiter::scene {

struct ObjError {
  std::string message; ///< the reason, without the file's name
};

/// The content of an OBJ text, with faces cut into triangles.
struct ObjFaces {
  /// Indices into the three lists; -1 if a face has none.
  struct Corner {
    int position = -1, st = -1, normal = -1;
    bool operator==(const Corner &) const = default;
  };
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> sts;
  std::vector<std::array<Corner, 3>> triangles;
};

/// Reads v, vt, vn and f; ignores groups and materials. A face has at most 256 corners, and all
/// triangles together at most kMaxVertices. Fails for an index without a vertex, a number that is
/// not finite, too many of anything, or no face at all.
[[nodiscard]] Result<ObjFaces, ObjError> readObj(const std::string &text);

/// Builds the mesh, with one vertex for each distinct corner. Without normals in the file, a normal
/// is the mean of the faces around a position, weighted by area. A tangent is the direction in
/// which s increases. Without texture coordinates these are (0, 0) and tangents are any direction
/// across the normal.
[[nodiscard]] Mesh meshOf(const ObjFaces &faces);

/// Triangulates a plane polygon in three dimensions, which may be concave. Returns three corner
/// numbers for each triangle.
[[nodiscard]] std::vector<std::array<std::size_t, 3>>
cutPolygon(const std::vector<glm::vec3> &corners);

} // namespace arbiter::scene
