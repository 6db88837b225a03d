#pragma once
#include <cstdint>

#include "swrast/rasterize.h"

/// Vertices to triangles and lines. Any primitive of a draw can be asked for by its number.
namespace arbiter::swrast {

/// Places in the draw's sequence of vertices, 0 to count - 1.
struct TriangleCorners {
  std::uint32_t corner[3];
  std::uint32_t provoking;
  /// Bit k: the side from corner k to the next is a side of the primitive, not a diagonal; where it
  /// is drawn hangs on the edge flag of corner k too.
  std::uint32_t sides;
};
struct LineEnds {
  std::uint32_t end[2];
  std::uint32_t provoking;
  bool restartsStipple;
};

[[nodiscard]] bool isPolygonal(Topology topology);
/// Whether the first vertex of such a primitive is the provoking one.
[[nodiscard]] bool provokesFirst(const RasterState &state, Topology topology);
[[nodiscard]] std::uint32_t triangleCount(Topology topology, std::uint32_t count);
/// Wound as the primitive is. Quads and polygons are cut as hosts cut them, so that what is not
/// flat looks the same: a quad from its first corner to the third, and in draws that are clipped or
/// not filled, or where the first vertex provokes (`otherDiagonal`), from the second to the fourth.
[[nodiscard]] TriangleCorners triangleAt(Topology topology, std::uint32_t count, std::uint32_t i,
                                         bool provokingIsFirst, bool otherDiagonal);
[[nodiscard]] std::uint32_t lineCount(Topology topology, std::uint32_t count);
[[nodiscard]] LineEnds lineAt(Topology topology, std::uint32_t count, std::uint32_t i,
                              bool provokingIsFirst);

} // namespace arbiter::swrast
