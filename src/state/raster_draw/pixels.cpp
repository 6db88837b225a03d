#include "state/raster_draw/pixels.h"

#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/pipeline.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

bool shadesRasterValues(RasterContext &context) {
  if (context.insideBeginEnd || context.listMode != 0 || !usesRasterizer(context) ||
      !context.software)
    return false;
  const Outcome outcome = outcomeOf(context, [&] { return decideFragments(context); });
  return outcome.ok() && pipelineOf(context).readsRasterValues();
}

bool tryPixels(RasterContext &context, const imaging::Pixels &pixels) {
  return conclude(context, outcomeOf(context, [&] {
                    const Outcome outcome = decideFragments(context);
                    return outcome.ok() ? pipelineOf(context).shadePixels(context, pixels)
                                        : outcome;
                  }));
}

} // namespace arbiter::state
