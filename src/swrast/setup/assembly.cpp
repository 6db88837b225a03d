#include "swrast/setup/assembly.h"

namespace arbiter::swrast {

bool isPolygonal(Topology topology) { return topology >= Topology::Triangles; }

bool provokesFirst(const RasterState &state, Topology topology) {
  const bool quads = topology == Topology::Quads || topology == Topology::QuadStrip;
  if (quads)
    return state.quadsProvokingIsFirst;
  return state.provokingIsFirst != (topology == Topology::Triangles && state.partsProvokeOtherwise);
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

} // namespace arbiter::swrast
