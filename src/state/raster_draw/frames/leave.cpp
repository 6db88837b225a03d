#include "state/raster_draw/frames/leave.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "state/programs/program_bind.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

using Clock = std::chrono::steady_clock;

LeftAlone::Seen seenOf(const ContextState &state) {
  const auto countOf = [&](Fallback reason) { return state.fallbacks[std::size_t(reason)]; };
  LeftAlone::Seen seen = {.drawn = state.drawn,
                          .refused = countOf(Fallback::Target),
                          .lists = countOf(Fallback::List),
                          .passing = countOf(Fallback::Shared) + countOf(Fallback::Compiling)};
  seen.others = std::accumulate(state.fallbacks.begin(), state.fallbacks.end(), std::uint64_t(0)) -
                seen.refused - seen.lists;
  return seen;
}

/// Counts a frame in which the rasterizer drew nothing. A frame without draws does not count.
void judgeLeftAlone(const ContextState &state, LeftAlone &left) {
  const LeftAlone::Seen now = seenOf(state), before = std::exchange(left.seen, now);
  const bool drew = now.drawn != before.drawn;
  if (drew || now.others != before.others)
    left.refusedFrames = 0;
  else if (now.refused != before.refused)
    ++left.refusedFrames;
  if (drew || now.passing != before.passing)
    left.gainlessFrames = 0;
  else if (now.refused + now.lists + now.others != before.refused + before.lists + before.others)
    left.gainlessFrames = state.lacked ? left.gainlessFrames + 1 : 0;
  if (drew)
    left.mostGainless = kGainlessFrames;
}

bool gainsNothing(const LeftAlone &left) {
  return left.refusedFrames >= (left.before ? kRefusedAgain : kRefusedFrames) ||
         left.gainlessFrames >= left.mostGainless;
}

void leave(RasterContext &context, LeftAlone &left) {
  ContextState &state = *context.software;
  invalidateProgram(context);
  state.history.look.becomesHosts(); // the host may draw looks meanwhile
  keepHistory(state.history);
  Figures figures;
  figures.add(context);
  const std::uint64_t patience = left.patience;
  // An early return, made because frame times changed, must not postpone the regular one.
  const std::uint64_t until =
      left.until > context.counters.frames ? left.until : context.counters.frames + kFramesAlone;
  const bool keepsLists = left.refusedFrames < kRefusedAgain;
  state.residency.leave();
  context.software = nullptr;
  context.softwarePossible = context.softwareListens = context.hostIsBehind = false;
  left = {};
  left.before = true;
  left.mostGainless = kRefusedAgain;
  left.keepsLists = keepsLists;
  left.figures = figures;
  left.since = context.counters.frames;
  left.until = until;
  left.patience = patience;
}

/// Measures a frame of the host's. The first one is skipped, because it pays for the change of
/// sides.
void time(LeftAlone &left, std::uint64_t frame, Clock::time_point now) {
  const auto took = now - std::exchange(left.frameEnd, now);
  const float milliseconds = std::chrono::duration<float, std::milli>(took).count();
  if (frame < 2)
    return;
  if (frame - 2 >= LeftAlone::kTimedFrames)
    return left.times.look(milliseconds);
  left.timed[frame - 2] = milliseconds;
  if (frame - 2 == LeftAlone::kTimedFrames - 1) {
    float *const middle = left.timed + LeftAlone::kTimedFrames / 2;
    std::nth_element(left.timed, middle, left.timed + LeftAlone::kTimedFrames);
    left.times.decide(*middle);
  }
}

/// True if a context that was left alone must be looked at again.
bool isToReturn(LeftAlone &left, std::uint64_t frames, Clock::time_point now) {
  if (left.returns)
    return false;
  time(left, frames - left.since, now);
  if (frames >= left.until) {
    left.patience = kLeastAlone;
    return true;
  }
  if (!left.times.areOthers() || frames - left.since <= left.patience)
    return false;
  left.patience = std::min(2 * left.patience, kFramesAlone);
  return true;
}

} // namespace

void leaveOrReturn(RasterContext &context, Clock::time_point now) {
  if (context.insideBeginEnd || context.listMode != 0)
    return;
  const ContextState *const state = context.software.get();
  if (state && !state->steady) {
    if (!context.leftAlone)
      context.leftAlone = std::make_unique<LeftAlone>();
    LeftAlone &left = *context.leftAlone;
    judgeLeftAlone(*state, left);
    if (gainsNothing(left))
      leave(context, left);
  } else if (!state && context.leftAlone &&
             isToReturn(*context.leftAlone, context.counters.frames, now)) {
    context.leftAlone->returns = true;
    context.softwareRefused = false; // the next draw calls engage()
    invalidateProgram(context);
  }
}

} // namespace arbiter::state
