#include "swrast/assembly.h"

namespace arbiter::swrast {

bool isPolygonal(Topology topology) { return topology >= Topology::Triangles; }

bool provokesFirst(const RasterState &state, Topology topology) {
  const bool quads = topology == Topology::Quads || topology == Topology::QuadStrip;
  return quads ? state.quadsProvokingIsFirst : state.provokingIsFirst;
}

std::uint32_t triangleCount(Topology topology, std::uint32_t count) {
  switch (topology) {
  case Topology::Triangles:
    return count / 3;
  case Topology::TriangleStrip:
  case Topology::TriangleFan:
  case Topology::Polygon:
    return count < 3 ? 0 : count - 2;
  case Topology::Quads:
    return count / 4 * 2;
  case Topology::QuadStrip:
    return count < 4 ? 0 : (count / 2 - 1) * 2;
  default:
    return 0;
  }
}

TriangleCorners triangleAt(Topology topology, std::uint32_t count, std::uint32_t i,
                           bool provokingIsFirst, bool otherDiagonal) {
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
    return i & 1 ? TriangleCorners{{a, a + 1, a + 3}, provoking, 3}
                 : TriangleCorners{{a + 2, a, a + 3}, provoking, 5};
  }
  default:
    return {};
  }
}

std::uint32_t lineCount(Topology topology, std::uint32_t count) {
  switch (topology) {
  case Topology::Lines:
    return count / 2;
  case Topology::LineStrip:
    return count < 2 ? 0 : count - 1;
  case Topology::LineLoop:
    return count < 2 ? 0 : count;
  default:
    return 0;
  }
}

LineEnds lineAt(Topology topology, std::uint32_t count, std::uint32_t i, bool provokingIsFirst) {
  if (topology == Topology::Lines)
    return {{2 * i, 2 * i + 1}, provokingIsFirst ? 2 * i : 2 * i + 1, true};
  const std::uint32_t next = i + 1 == count ? 0 : i + 1;
  return {{i, next}, provokingIsFirst ? i : next, i == 0};
}

} // namespace arbiter::swrast
