#include "state/software/frame.h"

#include "state/context.h"
#include "state/software/residency.h"

namespace arbiter::state::software {

namespace {

std::uint64_t transfers(const Context &context) {
  const ResidencyStatistics statistics = residencyStatistics(context);
  return statistics.downloads + statistics.uploads;
}

void judge(Context &context, bool moved) {
  ContextState &state = *context.software;
  state.wholeFrames = state.hostTurns == 0;
  state.hostTurns = 0;
  state.backOff.frameEnded(moved, std::chrono::steady_clock::now());
}

} // namespace

bool presentFrame(Context &context) {
  ContextState &state = *context.software;
  state.presents = true;
  const bool moved = transfers(context) != state.transfersSeen;
  const bool shown = present(context);
  state.transfersSeen = transfers(context);
  judge(context, moved);
  return shown;
}

void finishFrame(Context &context) {
  ContextState &state = *context.software;
  if (state.presents)
    return;
  const std::uint64_t now = transfers(context);
  judge(context, now != state.transfersSeen);
  state.transfersSeen = now;
}

} // namespace arbiter::state::software
