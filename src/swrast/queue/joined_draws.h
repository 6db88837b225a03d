#pragma once
#include <cstdint>
#include <vector>

#include "swrast/queue/given_draw.h"
#include "swrast/setup/draw.h"

/// Joins small draws that differ in their vertices alone, for example each leaf of a tree with its
/// own matrix. Work that is done once a draw (window coordinates, vectors of triangles, lists of
/// tiles) is then done once for all of them.
namespace arbiter::swrast {

/// How much of a draw of a few filled triangles is visible.
enum class Sight : std::uint8_t {
  Unknown, ///< not such a draw
  None,    ///< all of it lies outside one side of the view volume
  Part,
  Whole, ///< nothing is clipped
};
[[nodiscard]] Sight sightOf(const GivenDraw &given);

/// The joined triangles of draws that need no clipping, in order, each with its own provoking
/// vertex. Their pixels are those of the single draws. Memory is allocated once, so adding a draw
/// neither allocates nor fails.
class JoinedDraws {
public:
  /// Most vertices of one draw. Larger draws gain nothing by joining; their Sight is Unknown.
  static constexpr std::uint32_t kMaxOfOne = 64;
  static constexpr std::uint32_t kMaxVertices = 1024, kMaxTriangles = 1024;

  /// Adds a draw. Returns false if it must wait until the joined draws are drawn. Requires that the
  /// draw is Sight::Whole and has the state of those before. The first one may throw
  /// std::bad_alloc.
  [[nodiscard]] bool add(const GivenDraw &given);
  [[nodiscard]] bool isEmpty() const { return m_triangles == 0; }
  void clear() { m_vertices.count = m_triangles = 0; }

  /// The joined triangles: `indices` into `vertices`, as Topology::Triangles.
  [[nodiscard]] const Vertices &vertices() const { return m_vertices; }
  [[nodiscard]] const std::uint32_t *indices() const { return m_indices.data(); }
  [[nodiscard]] std::uint32_t count() const { return 3 * m_triangles; }
  /// The value of Draw::provokingAt.
  static constexpr std::uint32_t kProvokingAt = 3 * kMaxTriangles;

private:
  /// Allocates the input arrays that the draw has and its shading reads.
  void begin(const GivenDraw &given);
  [[nodiscard]] bool hasSameArrays(const GivenDraw &given);
  [[nodiscard]] bool hasRoom(const GivenDraw &given, std::uint32_t triangles) const;
  void copyVertices(const GivenDraw &given);
  void addTriangles(const GivenDraw &given, std::uint32_t triangles);

  Vertices m_vertices;         ///< its pointers point into m_values
  std::vector<float> m_values; ///< kMaxVertices for each array
  /// Three indices for each triangle; from kProvokingAt on, the provoking vertex of each.
  std::vector<std::uint32_t> m_indices;
  std::uint32_t m_triangles = 0;
};

} // namespace arbiter::swrast
