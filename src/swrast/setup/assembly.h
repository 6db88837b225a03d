#pragma once
#include <cstdint>

#include "swrast/draw_input.h"

/// Primitive assembly: vertices to triangles and lines. Each primitive of a draw can be computed
/// from its number.
namespace arbiter::swrast {

/// A triangle, as positions in the draw's sequence of vertices: 0 to count - 1.
struct TriangleCorners {
  std::uint32_t corner[3];
  std::uint32_t provoking;
  /// Bit k is set if the side from corner k to the next is a side of the primitive, not a diagonal.
  /// Whether it is drawn also depends on the edge flag of corner k.
  std::uint32_t sides;
};
/// A line, as positions in the draw's sequence of vertices.
struct LineEnds {
  std::uint32_t end[2];
  std::uint32_t provoking;
  bool restartsStipple; ///< true if the line stipple pattern begins anew here
};

/// True if the primitives are triangles, quads or polygons: those with faces.
[[nodiscard]] bool isPolygonal(Topology topology);
/// True if a primitive's first vertex is the provoking one. Requires isPolygonal(topology).
[[nodiscard]] bool provokesFirst(const RasterState &state, Topology topology);
/// True if quads of a draw are split along their other diagonal (triangleAt()). Hosts have two
/// paths. The one that clips and stipples always splits quads so. The plain one does it if the
/// provoking vertex matters or is the first, for indices, and in lists, but never for quad strips.
[[nodiscard]] inline bool cutsOtherwise(const RasterState &state, Topology topology, bool clipped) {
  return clipped || state.inClippingPath || state.polygonStipple != nullptr ||
         (topology != Topology::QuadStrip && (state.secondDiagonal || state.provokingIsFirst));
}
/// Returns the number of triangles that `count` vertices make, or 0 for points and lines. Vertices
/// that complete no triangle are ignored.
[[nodiscard]] std::uint32_t triangleCount(Topology topology, std::uint32_t count);
/// Returns triangle `i` of triangleCount(), with the primitive's winding. Quads and polygons are
/// split as hosts split them, so that non-planar ones look the same. A quad is split from its first
/// corner to the third, or, if `otherDiagonal` is true, from the second to the fourth. In a quad
/// strip, `otherDiagonal` swaps the order of the two halves instead.
[[nodiscard]] inline TriangleCorners triangleAt(Topology topology, std::uint32_t count,
                                                std::uint32_t i, bool provokingIsFirst,
                                                bool otherDiagonal) {
  switch (topology) {
  case Topology::Triangles: {
    const std::uint32_t a = 3 * i;
    return {{a, a + 1, a + 2}, provokingIsFirst ? a : a + 2, 7};
  }
  case Topology::TriangleStrip:
    // Every other triangle has its first two corners swapped, to keep the winding.
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
    // The quad's corners are a, a + 1, a + 3, a + 2.
    const std::uint32_t a = i / 2 * 2;
    const std::uint32_t provoking = provokingIsFirst ? a : a + 3;
    return (i & 1) == (otherDiagonal ? 1u : 0u) ? TriangleCorners{{a, a + 1, a + 3}, provoking, 3}
                                                : TriangleCorners{{a + 2, a, a + 3}, provoking, 5};
  }
  default:
    return {};
  }
}
/// Returns the number of lines that `count` vertices make, or 0 if the topology is not lines.
[[nodiscard]] std::uint32_t lineCount(Topology topology, std::uint32_t count);
/// Returns line `i` of lineCount().
[[nodiscard]] inline LineEnds lineAt(Topology topology, std::uint32_t count, std::uint32_t i,
                                     bool provokingIsFirst) {
  if (topology == Topology::Lines)
    return {{2 * i, 2 * i + 1}, provokingIsFirst ? 2 * i : 2 * i + 1, true};
  const std::uint32_t next = i + 1 == count ? 0 : i + 1;
  return {{i, next}, provokingIsFirst ? i : next, i == 0};
}

} // namespace arbiter::swrast
