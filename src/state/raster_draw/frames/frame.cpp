#include "state/raster_draw/frames/frame.h"

#include <ctime>
#include <numeric>

#include "state/core/context.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/functions/compile_thread.h"
#include "state/raster_draw/functions/start_note.h"

namespace arbiter::state::software {

namespace {

std::uint64_t transfers(const ContextState &state) {
  const ResidencyStatistics statistics = state.residency.statistics();
  return statistics.downloads + statistics.uploads;
}

/// Returns the number of draws on either side, plus the host's work that was no draw of the
/// application.
std::uint64_t workOf(const ContextState &state) {
  return std::accumulate(state.fallbacks.begin(), state.fallbacks.end(),
                         state.drawn + state.hostTurns);
}

std::chrono::nanoseconds processorTime() {
  timespec time{};
  if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time) != 0)
    return {};
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// Ignores a frame whose draws the host did for a client's sake.
void passOver(ContextState &state) {
  state.unjudged = state.observed = state.hostDrew = state.depthsTested = state.lacked = false;
  state.hostTurns = state.lookTurns = 0;
  state.workSeen = workOf(state);
  state.drawnSeen = state.drawn;
  state.history.backOff.frameIgnored(std::chrono::steady_clock::now());
}

/// True if the rasterizer's part of a mixed frame was too small to be worth moving images for it.
/// Frames with programs never count: programs may be costly on the host, however few the draws.
bool mixedInVain(const ContextState &state, bool moved) {
  constexpr std::uint64_t kLeastShare = 4;
  const std::uint64_t drawn = state.drawn - state.drawnSeen;
  return moved && state.drawsPlain && drawn != 0 &&
         drawn * kLeastShare < workOf(state) - state.workSeen;
}

/// Updates the history after a frame in which something was drawn.
void judgeWhole(ContextState &state, bool moved) {
  FrameHistory &history = state.history;
  history.waitsForCode = false;
  // A frame that the host drew before it could be judged says nothing either.
  if (state.hostTurns != 0 || !state.unjudged) {
    history.judged = true;
    history.wholeFrames = history.trials.frameEnded(state.hostTurns == 0, state.depthsTested);
    if (!state.steady)
      noteFrame(state.hostTurns == 0);
  }
  const bool lookedAt = history.backOff.engaged() && !state.unjudged;
  if (history.look.frameEnded(lookedAt && state.hostTurns == state.lookTurns))
    history.wholeFrames = true;
  history.unjudgedFrames = state.unjudged ? history.unjudgedFrames + 1 : 0;
  state.unjudged = false;
  state.lacked = state.hostTurns > state.lookTurns && history.backOff.engaged() &&
                 !history.look.isRasterizers();
  history.mixesInVain =
      state.hostTurns != 0 && (history.mixesInVain || (state.lacked && mixedInVain(state, moved)));
  state.hostTurns = state.lookTurns = 0;
  state.workSeen = workOf(state);
  state.drawnSeen = state.drawn;
}

void judge(Context &context, bool moved) {
  ContextState &state = *context.software;
  if (state.observed)
    return passOver(state);
  const bool plain = state.drawsPlain && !state.hostDrew && state.hostTurns == 0;
  // An empty frame says nothing about the next one.
  const bool drew = workOf(state) != state.workSeen;
  if (drew) {
    frameEndsForCompiler();
    judgeWhole(state, moved);
  }
  state.hostDrew = state.depthsTested = false;
  state.history.backOff.frameEnded(
      {moved, plain, state.history.look.isRasterizers(),
       state.history.backOff.tries() ? processorTime() : std::chrono::nanoseconds()},
      std::chrono::steady_clock::now());
  if (drew && !state.steady)
    keepHistory(state.history);
}

void endFrame(Context &context) {
  ContextState &state = *context.software;
  const std::uint64_t now = transfers(state);
  judge(context, now != state.transfersSeen);
  state.transfersSeen = now;
}

} // namespace

bool presentFrame(Context &context) {
  ContextState &state = *context.software;
  state.presents = true;
  const bool moved = transfers(state) != state.transfersSeen;
  const bool shown = state.residency.present();
  state.transfersSeen = transfers(state);
  judge(context, moved);
  return shown;
}

void finishFrame(Context &context) {
  ContextState &state = *context.software;
  if (state.presents)
    return;
  state.finishes = true;
  endFrame(context);
}

void clearsTarget(Context &context, GLbitfield mask) {
  ContextState &state = *context.software;
  if (state.presents || state.finishes)
    return;
  const void *const target = state.residency.wholeTargetCleared(mask);
  if (!target)
    return;
  if (!state.frameTarget)
    state.frameTarget = target;
  else if (target == state.frameTarget)
    endFrame(context);
}

} // namespace arbiter::state::software
