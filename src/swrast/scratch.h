#pragma once
#include <vector>

#include "swrast/clip.h"
#include "swrast/setup.h"

/// What the stages of one draw look at and keep.
namespace arbiter::swrast {

struct Draw {
  const RasterState &state;
  const Shading &shading;
  Topology topology;
  const Vertices &vertices;
  const std::uint32_t *indices;
  std::uint32_t first, count;
  Viewport viewport;
  const WindowVertex *window = nullptr; ///< of all vertices that the draw uses
  bool otherDiagonal = false;           ///< of quads: see triangleAt()

  [[nodiscard]] std::uint32_t vertexAt(std::uint32_t place) const {
    return indices ? indices[place] : first + place;
  }
  [[nodiscard]] bool isFilled() const {
    return state.front == PolygonMode::Fill && state.back == PolygonMode::Fill;
  }
};

} // namespace arbiter::swrast
