#include "state/raster_draw/frames/frame_history.h"

#include <mutex>

namespace arbiter::state::software {

namespace {

/// Trivially destroyed, so that contexts may outlive static destructors. Only ever tried: a thread
/// that is killed or forked away from inside leaves it locked for good, and nothing then waits.
struct {
  std::mutex mutex;
  FrameHistory history;
} g_last;

} // namespace

FrameHistory historyOfProcess() {
  const std::unique_lock lock(g_last.mutex, std::try_to_lock);
  if (!lock.owns_lock())
    return {};
  FrameHistory history = g_last.history;
  history.backOff.forgetStatistics();
  return history;
}

void keepHistory(const FrameHistory &history) {
  const std::unique_lock lock(g_last.mutex, std::try_to_lock);
  if (lock.owns_lock())
    g_last.history = history;
}

} // namespace arbiter::state::software
