#include "state/raster_draw/frames/frame.h"

#include <ctime>
#include <numeric>

#include "state/raster_draw/context_state.h"
#include "state/raster_draw/functions/compile_thread.h"
#include "state/raster_draw/functions/start_note.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

std::uint64_t transfers(const ContextState &state) {
  const ResidencyStatistics statistics = state.residency.statistics();
  return statistics.downloads + statistics.uploads;
}

/// Returns the number of draws on either side, plus the host's work that was no draw of the
/// application.
std::uint64_t workOf(const ContextState &state) {
  return std::accumulate(state.fallbacks.begin(), state.fallbacks.end(),
                         state.drawn + state.frame.hostTurns);
}

void startFrame(ContextState &state) {
  state.frame = {};
  state.seen.work = workOf(state);
  state.seen.drawn = state.drawn;
}

std::chrono::nanoseconds processorTime() {
  timespec time{};
  if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time) != 0)
    return {};
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// Ignores a frame whose draws the host did for a client's sake.
void passOver(ContextState &state) {
  state.lacked = false;
  startFrame(state);
  state.history.backOff.frameIgnored(std::chrono::steady_clock::now());
}

/// True if the rasterizer's part of a mixed frame was too small to be worth moving images for it.
/// Frames with programs never count: programs may be costly on the host, however few the draws.
bool mixedInVain(const ContextState &state, bool moved) {
  constexpr std::uint64_t kLeastShare = 4;
  const std::uint64_t drawn = state.drawn - state.seen.drawn;
  return moved && state.habits.drawsPlain && drawn != 0 &&
         drawn * kLeastShare < workOf(state) - state.seen.work;
}

/// Updates the history after a frame in which something was drawn.
void judgeWhole(ContextState &state, bool moved) {
  FrameHistory &history = state.history;
  history.waitsForCode = false;
  // A frame that the host drew before it could be judged says nothing either.
  if (state.frame.hostTurns != 0 || !state.frame.unjudged) {
    history.judged = true;
    history.wholeFrames =
        history.trials.frameEnded(state.frame.hostTurns == 0, state.frame.depthsTested);
    if (!state.steady)
      noteFrame(state.frame.hostTurns == 0);
  }
  const bool lookedAt = history.backOff.engaged() && !state.frame.unjudged;
  if (history.look.frameEnded(lookedAt && state.frame.hostTurns == state.frame.lookTurns))
    history.wholeFrames = true;
  history.unjudgedFrames = state.frame.unjudged ? history.unjudgedFrames + 1 : 0;
  state.lacked = state.frame.hostTurns > state.frame.lookTurns && history.backOff.engaged() &&
                 !history.look.isRasterizers();
  history.mixesInVain = state.frame.hostTurns != 0 &&
                        (history.mixesInVain || (state.lacked && mixedInVain(state, moved)));
}

void judge(RasterContext &context, bool moved) {
  ContextState &state = *context.software;
  if (state.frame.observed)
    return passOver(state);
  const bool plain = state.habits.drawsPlain && !state.frame.hostDrew && state.frame.hostTurns == 0;
  // An empty frame says nothing about the next one.
  const bool drew = workOf(state) != state.seen.work;
  if (drew) {
    frameEndsForCompiler();
    judgeWhole(state, moved);
  }
  startFrame(state);
  state.history.backOff.frameEnded(
      {moved, plain, state.history.look.isRasterizers(),
       state.history.backOff.tries() ? processorTime() : std::chrono::nanoseconds()},
      std::chrono::steady_clock::now());
  if (drew && !state.steady)
    keepHistory(state.history);
}

void endFrame(RasterContext &context) {
  ContextState &state = *context.software;
  const std::uint64_t now = transfers(state);
  judge(context, now != state.seen.transfers);
  state.seen.transfers = now;
}

} // namespace

bool presentFrame(RasterContext &context) {
  ContextState &state = *context.software;
  state.habits.presents = true;
  const bool moved = transfers(state) != state.seen.transfers;
  const bool shown = state.residency.present();
  state.seen.transfers = transfers(state);
  judge(context, moved);
  return shown;
}

void finishFrame(RasterContext &context) {
  ContextState &state = *context.software;
  if (state.habits.presents)
    return;
  state.habits.finishes = true;
  endFrame(context);
}

void clearsTarget(RasterContext &context, GLbitfield mask) {
  ContextState &state = *context.software;
  if (state.habits.presents || state.habits.finishes)
    return;
  const void *const target = state.residency.wholeTargetCleared(mask);
  if (!target)
    return;
  if (!state.frameTarget)
    state.frameTarget = target;
  else if (target == state.frameTarget)
    endFrame(context);
}

} // namespace arbiter::state
