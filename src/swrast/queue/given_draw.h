#pragma once
#include <cstdint>

#include "swrast/draw_input.h"
#include "swrast/queue/queued_state.h"

namespace arbiter::swrast {

/// A draw to be added to a queue: the arguments of rasterize(), and what they refer to.
struct GivenDraw {
  const RasterState &state;
  const Shading &shading;
  Topology topology;
  const Vertices &vertices;
  const std::uint32_t *indices;
  std::uint32_t first, count;
  const ShadingUse &use;
  bool isSameState = false; ///< true if it has the state of the batch's last draw
};

} // namespace arbiter::swrast
