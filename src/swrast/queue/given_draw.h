#pragma once
#include <cstdint>

#include "swrast/draw_input.h"
#include "swrast/queue/queued_state.h"

namespace arbiter::swrast {

/// A draw as it is added to a queue: what rasterize() is called with, and what that refers to.
struct GivenDraw {
  const RasterState &state;
  const Shading &shading;
  Topology topology;
  const Vertices &vertices;
  const std::uint32_t *indices;
  std::uint32_t first, count;
  const ShadingUse &use;
  bool isSameState = false; ///< as the batch's last draw's
};

} // namespace arbiter::swrast
