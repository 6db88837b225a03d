#pragma once
#include "swrast/queue/queued_state.h"
#include "swrast/setup/draw.h"

namespace arbiter::swrast {

/// A draw to be added to a queue.
struct GivenDraw : DrawArguments {
  const ShadingUse &use;
  bool isSameState = false; ///< true if it has the state of the batch's last draw
};

} // namespace arbiter::swrast
