#pragma once
#include <memory>

#include "state/host_draw/draw_context.h"
#include "state/objects/drawable.h"
#include "state/objects/neighbour_epoch.h"

namespace arbiter::state {

struct ContextState;
struct LeftAlone;

/// Adds the rasterizer.
struct RasterContext : DrawContext {
  /// The rasterizer's state; null if the rasterizer is not used here.
  std::unique_ptr<ContextState> software;
  bool softwareRefused = false;         ///< decided for good: no rasterizer here
  std::unique_ptr<LeftAlone> leftAlone; ///< null until the context was left to the host
                                        ///< once (frames/leave.h)
  Drawable drawable;                    ///< from the last make-current
  NeighbourEpoch neighbours;

protected:
  constexpr RasterContext();
  ~RasterContext();
};

/// Returns the step of the rasterizer: every object is a whole Context, so it has one.
[[nodiscard]] inline RasterContext &rasterStep(ContextHot &context) {
  return static_cast<RasterContext &>(context);
}

} // namespace arbiter::state
