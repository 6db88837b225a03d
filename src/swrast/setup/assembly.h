#pragma once
#include <cstdint>

#include "swrast/draw_input.h"

/// Vertices to triangles and lines. Any primitive of a draw can be asked for by its number.
namespace arbiter::swrast {

/// Places in the draw's sequence of vertices, 0 to count - 1.
struct TriangleCorners {
  std::uint32_t corner[3];
  std::uint32_t provoking;
  /// Bit k: the side from corner k to the next is a side of the primitive, not a diagonal; where it
  /// is drawn depends on the edge flag of corner k too.
  std::uint32_t sides;
};
/// A line, in the same numbers.
struct LineEnds {
  std::uint32_t end[2];
  std::uint32_t provoking;
  bool restartsStipple; ///< the line stipple begins again here
};

/// Whether its primitives are triangles, quads or polygons: those with faces.
[[nodiscard]] bool isPolygonal(Topology topology);
/// Whether the first vertex of such a primitive is the provoking one.
[[nodiscard]] bool provokesFirst(const RasterState &state, Topology topology);
/// Whether quads of a draw are cut otherwise (triangleAt()). Hosts clip and stipple in another path
/// than the plain one, which cuts them so; and the plain one does, but not with strips, where the
/// provoking vertex counts or is the first, by indices and in lists.
[[nodiscard]] inline bool cutsOtherwise(const RasterState &state, Topology topology, bool clipped) {
  return clipped || state.inOtherPath || state.polygonStipple != nullptr ||
         (topology != Topology::QuadStrip && (state.secondDiagonal || state.provokingIsFirst));
}
/// How many triangles `count` vertices make; vertices that complete none are ignored. 0 of points
/// and lines.
[[nodiscard]] std::uint32_t triangleCount(Topology topology, std::uint32_t count);
/// Triangle `i` of triangleCount(), wound as the primitive is. Quads and polygons are cut as hosts
/// cut them, so that what is not flat looks the same: a quad from its first corner to the third,
/// and in draws that are clipped or not filled, or where the first vertex provokes
/// (`otherDiagonal`), from the second to the fourth. Of strips the halves of a quad change places
/// instead, and not for the sake of the provoking vertex.
[[nodiscard]] inline TriangleCorners triangleAt(Topology topology, std::uint32_t count,
                                                std::uint32_t i, bool provokingIsFirst,
                                                bool otherDiagonal) {
  switch (topology) {
  case Topology::Triangles: {
    const std::uint32_t a = 3 * i;
    return {{a, a + 1, a + 2}, provokingIsFirst ? a : a + 2, 7};
  }
  case Topology::TriangleStrip:
    // Every other triangle runs the other way round.
    if (i & 1)
      return {{i + 1, i, i + 2}, provokingIsFirst ? i : i + 2, 7};
    return {{i, i + 1, i + 2}, provokingIsFirst ? i : i + 2, 7};
  case Topology::TriangleFan:
    return {{0, i + 1, i + 2}, provokingIsFirst ? i + 1 : i + 2, 7};
  case Topology::Polygon: {
    const std::uint32_t sides = 2u | (i == 0 ? 1u : 0u) | (i + 3 == count ? 4u : 0u);
    return {{0, i + 1, i + 2}, 0, sides};
  }
  case Topology::Quads: {
    const std::uint32_t a = i / 2 * 4;
    const std::uint32_t provoking = provokingIsFirst ? a : a + 3;
    if (!otherDiagonal)
      return i & 1 ? TriangleCorners{{a, a + 2, a + 3}, provoking, 6}
                   : TriangleCorners{{a, a + 1, a + 2}, provoking, 3};
    return i & 1 ? TriangleCorners{{a + 1, a + 2, a + 3}, provoking, 3}
                 : TriangleCorners{{a, a + 1, a + 3}, provoking, 5};
  }
  case Topology::QuadStrip: {
    // The quad is a, a + 1, a + 3, a + 2.
    const std::uint32_t a = i / 2 * 2;
    const std::uint32_t provoking = provokingIsFirst ? a : a + 3;
    return (i & 1) == (otherDiagonal ? 1u : 0u) ? TriangleCorners{{a, a + 1, a + 3}, provoking, 3}
                                                : TriangleCorners{{a + 2, a, a + 3}, provoking, 5};
  }
  default:
    return {};
  }
}
/// How many lines `count` vertices make; 0 of anything but lines.
[[nodiscard]] std::uint32_t lineCount(Topology topology, std::uint32_t count);
/// Line `i` of lineCount().
[[nodiscard]] inline LineEnds lineAt(Topology topology, std::uint32_t count, std::uint32_t i,
                                     bool provokingIsFirst) {
  if (topology == Topology::Lines)
    return {{2 * i, 2 * i + 1}, provokingIsFirst ? 2 * i : 2 * i + 1, true};
  const std::uint32_t next = i + 1 == count ? 0 : i + 1;
  return {{i, next}, provokingIsFirst ? i : next, i == 0};
}

} // namespace arbiter::swrast
