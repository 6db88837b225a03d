#pragma once
#include <cstdint>
#include <vector>

#include "swrast/queue/given_draw.h"
#include "swrast/setup/draw.h"

/// Small draws that follow one another with nothing but their vertices changed, as one draw: each
/// leaf of a tree under its own matrix. What is done once a draw (window coordinates of a few
/// vertices, vectors of a few triangles, lists of tiles) is done once for all of them.
namespace arbiter::swrast {

/// What can be seen of a draw of few filled triangles.
enum class Sight : std::uint8_t {
  Unknown, ///< it is another draw
  None,    ///< all of it lies beyond one side of the view volume
  Part,
  Whole, ///< nothing is clipped
};
[[nodiscard]] Sight sightOf(const GivenDraw &given);

/// Triangles of draws that are not clipped, in order, each with its own provoking vertex: their
/// pixels are those of the draws one by one. Memory is taken once, so that to add one neither
/// allocates nor fails.
class JoinedDraws {
public:
  /// Of one draw: what has more vertices gains nothing, and has no Sight.
  static constexpr std::uint32_t kMostOfOne = 64;
  static constexpr std::uint32_t kMostVertices = 1024, kMostTriangles = 1024;

  /// False: it fits once what was joined is drawn. Requires: the draw is Sight::Whole, and has the
  /// state of those that were added. Throws std::bad_alloc where it is the first.
  [[nodiscard]] bool add(const GivenDraw &given);
  [[nodiscard]] bool isEmpty() const { return m_triangles == 0; }
  void clear() { m_vertices.count = m_triangles = 0; }

  /// They are what `indices` says of `vertices`, as Topology::Triangles.
  [[nodiscard]] const Vertices &vertices() const { return m_vertices; }
  [[nodiscard]] const std::uint32_t *indices() const { return m_indices.data(); }
  [[nodiscard]] std::uint32_t count() const { return 3 * m_triangles; }
  /// Draw::provokingAt
  static constexpr std::uint32_t kProvokingAt = 3 * kMostTriangles;

private:
  /// Has room for the arrays that the draw has of those that its shading reads.
  void begin(const GivenDraw &given);
  [[nodiscard]] bool hasSameArrays(const GivenDraw &given);
  [[nodiscard]] bool hasRoom(const GivenDraw &given, std::uint32_t triangles) const;
  void copyVertices(const GivenDraw &given);
  void addTriangles(const GivenDraw &given, std::uint32_t triangles);

  Vertices m_vertices;         ///< its pointers are to m_values
  std::vector<float> m_values; ///< kMostVertices for each array
  /// Three of each triangle; from kProvokingAt on the provoking vertex of each.
  std::vector<std::uint32_t> m_indices;
  std::uint32_t m_triangles = 0;
};

} // namespace arbiter::swrast
