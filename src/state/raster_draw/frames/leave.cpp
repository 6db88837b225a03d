#include "state/raster_draw/frames/leave.h"

#include <numeric>

#include "state/core/context.h"
#include "state/programs/program_bind.h"
#include "state/raster_draw/context_state.h"

namespace arbiter::state::software {

namespace {

constexpr std::uint64_t kNever = ~std::uint64_t(0);

/// Counts a frame whose draws were refused for their target, where nothing was drawn or refused for
/// another reason but that the host keeps a list. A frame without draws says nothing.
void judge(const ContextState &state, LeftAlone &left) {
  const std::uint64_t refused = state.fallbacks[std::size_t(Fallback::Target)];
  const std::uint64_t others =
      std::accumulate(state.fallbacks.begin(), state.fallbacks.end(), state.drawn) - refused -
      state.fallbacks[std::size_t(Fallback::List)];
  if (others != left.othersSeen)
    left.refusedFrames = 0;
  else if (refused != left.refusedSeen)
    ++left.refusedFrames;
  left.refusedSeen = refused;
  left.othersSeen = others;
}

void leave(Context &context, LeftAlone &left) {
  invalidateProgram(context);
  Figures figures;
  figures.add(context);
  context.software->residency.leave();
  context.software = nullptr;
  context.softwarePossible = context.softwareListens = context.hostIsBehind = false;
  left = {};
  left.before = true;
  left.figures = figures;
  left.until = context.frames + kFramesAlone;
}

} // namespace

void leaveOrReturn(Context &context) {
  if (context.insideBeginEnd || context.listMode != 0)
    return;
  const ContextState *const state = context.software.get();
  if (state && !state->steady) {
    if (!context.leftAlone)
      context.leftAlone = std::make_unique<LeftAlone>();
    LeftAlone &left = *context.leftAlone;
    judge(*state, left);
    if (left.refusedFrames >= (left.before ? kRefusedAgain : kRefusedFrames))
      leave(context, left);
  } else if (!state && context.leftAlone && context.frames >= context.leftAlone->until) {
    context.leftAlone->until = kNever;
    context.softwareRefused = false; // the next draw engages it
    invalidateProgram(context);
  }
}

} // namespace arbiter::state::software
