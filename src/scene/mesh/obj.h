#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh/mesh.h"
#include "util/result.h"

/// Meshes from OBJ files. They are not trusted: every index is checked, and how many there are.
namespace arbiter::scene {

struct ObjError {
  std::string message; ///< the reason, without the file's name
};

/// What an OBJ text says, faces cut into triangles.
struct ObjFaces {
  /// Numbers in the three lists; -1 where a face has none.
  struct Corner {
    int position = -1, st = -1, normal = -1;
    bool operator==(const Corner &) const = default;
  };
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> sts;
  std::vector<std::array<Corner, 3>> triangles;
};

/// Reads v, vt, vn and f; groups and materials are left aside. A face has at most 256 corners, and
/// all triangles together at most kMaxVertices. Errors: a number that names no vertex, one that is
/// not finite, too many of something, no face at all.
[[nodiscard]] Result<ObjFaces, ObjError> readObj(const std::string &text);

/// A vertex for each corner that is unlike the others. Where the file has no normals they are the
/// mean of the faces about a position, by their areas; tangents are where s grows, and across the
/// normal where there are no texture coordinates, which are then (0, 0).
[[nodiscard]] Mesh meshOf(const ObjFaces &faces);

/// The corners of a plane polygon in three dimensions, in order: three numbers for each of its
/// triangles, also where it is not convex.
[[nodiscard]] std::vector<std::array<std::size_t, 3>>
cutPolygon(const std::vector<glm::vec3> &corners);

} // namespace arbiter::scene
