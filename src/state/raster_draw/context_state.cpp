#include "state/raster_draw/context_state.h"

#include "host/host_table.h"
#include "state/core/exit_notice.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/frames/leave.h"
#include "state/raster_draw/functions/start_note.h"
#include "state/raster_draw/raster_context.h"
#include "state/share/share_group.h"
#include "util/flags.h"

namespace arbiter::state {

bool mayBeUsed(const RasterContext &context) {
  const Backend backend = settings().backend;
  return backend != Backend::Host && context.offered && context.numerics != fp::Numerics::Fp24 &&
         (backend != Backend::Auto || context.caps.onProcessor);
}

bool keepsLists(const RasterContext &context) {
  if (context.software || context.softwareRefused)
    return context.software || (context.leftAlone && context.leftAlone->keepsLists);
  return (settings().alwaysFixedFunction ||
          context.group->programApiUsed.load(std::memory_order_relaxed)) &&
         mayBeUsed(context);
}

bool keepsEarlyLists(const RasterContext &context) {
  return !context.software && !context.softwareRefused && context.counters.frames < kEarlyFrames &&
         mayBeUsed(context);
}

void expect(const RasterContext &context) {
  if (mayBeUsed(context))
    startEngineAsBefore();
}

void engage(RasterContext &context) {
  if (context.software || context.softwareRefused)
    return;
  context.softwareRefused = true;
  if (!mayBeUsed(context))
    return;
  watchExit();
  context.software = std::make_unique<ContextState>(context);
  context.software->forced = settings().backend == Backend::Swrast;
  context.software->steady = context.software->forced || debugFlag(DebugFlag::Steady);
  if (!context.software->steady)
    context.software->history = historyOfProcess();
  context.software->history.backOff.setForced(context.software->steady);
  context.dirty = dirty::kAll;
  context.softwarePossible = context.softwareListens = true;
  context.software->residency.enter(context.drawable);
}

// The mirror always queries the real host, even while calls are deferred (CoreContext::trueHost).
ContextState::ContextState(RasterContext &context)
    : mirror(context.trueHost ? *context.trueHost : *context.host, context.caps,
             context.attributesAlias ? context.aliases.get() : nullptr),
      residency({context, context.caps, context.errors.pending, context.neighbours,
                 context.group->deletedNames, context.group->textureViews, context.group->contexts,
                 draws, context.serial}) {}
ContextState::~ContextState() = default;

} // namespace arbiter::state
