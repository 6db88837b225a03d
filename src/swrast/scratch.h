#pragma once
#include <vector>

#include "swrast/clip.h"
#include "swrast/setup.h"

/// What the stages of one draw look at and keep.
namespace arbiter::swrast {

/// Kept by each thread that draws, so that a draw like the last one allocates nothing.
struct Scratch {
  std::vector<Shape> shapes;
};

struct Draw {
  const RasterState &state;
  const Shading &shading;
  Topology topology;
  const Vertices &vertices;
  const std::uint32_t *indices;
  std::uint32_t first, count;
  Viewport viewport;

  [[nodiscard]] std::uint32_t vertexAt(std::uint32_t place) const {
    return indices ? indices[place] : first + place;
  }
  [[nodiscard]] PolygonMode modeOf(bool backFacing) const {
    return backFacing ? state.back : state.front;
  }
};

} // namespace arbiter::swrast
