#include "state/raster_draw/frames/frame_history.h"

#include <mutex>

#include "state/raster_draw/functions/start_note.h"

namespace arbiter::state {

namespace {

/// The history of the last frame in this process. It has a trivial destructor, because contexts may
/// outlive static objects. The mutex is only tried: a thread may be killed, or the process forked,
/// while it is locked, and nothing must then wait for it.
struct {
  std::mutex mutex;
  FrameHistory history;
  bool kept = false; ///< true once a frame has ended
} g_last;

FrameHistory historyOfLastStart() {
  FrameHistory history;
  history.wholeFrames = history.waitsForCode = lastStart() == LastStart::WholeFrames;
  return history;
}

} // namespace

FrameHistory historyOfProcess() {
  const std::unique_lock lock(g_last.mutex, std::try_to_lock);
  if (!lock.owns_lock())
    return {};
  if (!g_last.kept)
    return historyOfLastStart();
  FrameHistory history = g_last.history;
  history.backOff.forgetStatistics();
  return history;
}

void keepHistory(const FrameHistory &history) {
  const std::unique_lock lock(g_last.mutex, std::try_to_lock);
  if (!lock.owns_lock())
    return;
  g_last.history = history;
  g_last.kept = true;
}

} // namespace arbiter::state
