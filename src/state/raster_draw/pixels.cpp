#include "state/raster_draw/pixels.h"

#include "state/core/context.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/pipeline.h"

namespace arbiter::state::software {

bool shadesRasterValues(Context &context) {
  if (context.insideBeginEnd || context.listMode != 0 || !usesRasterizer(context) ||
      !context.software)
    return false;
  Pipeline &pipeline = pipelineOf(context);
  const Outcome outcome = outcomeOf(context, [&] {
    const Outcome path = decideByPath(context);
    return path.ok() ? pipeline.chooseFragments(context) : path;
  });
  return outcome.ok() && pipeline.readsRasterValues();
}

bool tryPixels(Context &context, const imaging::Pixels &pixels) {
  return conclude(context, outcomeOf(context, [&] {
                    const Outcome outcome = decideByPath(context);
                    return outcome.ok() ? pipelineOf(context).shadePixels(context, pixels)
                                        : outcome;
                  }));
}

} // namespace arbiter::state::software
