#pragma once
#include <chrono>
#include <cstdint>

#include "state/raster_draw/frames/other_times.h"
#include "state/raster_draw/report.h"

/// Leaves contexts alone that gain nothing from the rasterizer. In a multisampled window every draw
/// is refused for its target. In other contexts something in each frame is the host's, and most
/// draws are the host's for its sake. Such a context would pay for following state and splitting
/// lists in vain, so the host gets it whole.
namespace arbiter::state {

/// Frames, with every draw refused for its target, after which the context is left alone.
inline constexpr int kRefusedFrames = 8;
/// Frames in which the rasterizer drew nothing because it lacks something, after which the context
/// is left alone.
inline constexpr int kGainlessFrames = 8;
/// Frames of either kind, for a context that was left alone before and has gained nothing since.
inline constexpr int kRefusedAgain = 2;
/// Frames until a context that was left alone is looked at again. It may draw to another target by
/// then.
inline constexpr std::uint64_t kFramesAlone = 1000;
/// Frames until then if frame times have changed, as after a title. The number doubles each time
/// that the context still gained nothing.
inline constexpr std::uint64_t kLeastAlone = 32;

struct LeftAlone {
  /// Counts of the draws of the current ContextState, at the end of the last frame.
  struct Seen {
    std::uint64_t drawn = 0;
    std::uint64_t refused = 0; ///< refused for their target
    std::uint64_t others = 0;  ///< refused for another reason, except lists that the host keeps
    std::uint64_t lists = 0;   ///< lists that the host keeps
    /// Part of `others` with passing reasons: a neighbour may leave, and code may be ready, soon.
    std::uint64_t passing = 0;
  };
  Seen seen;
  int refusedFrames = 0; ///< frames in a row with all draws refused for their target
  /// frames in a row drawn by the host because the rasterizer lacks something
  int gainlessFrames = 0;
  int mostGainless = kGainlessFrames;
  bool before = false;  ///< true if the context was left alone once
  bool returns = false; ///< true if the next draw gives it a ContextState
  /// True if the target was not the reason, so that draws may become the rasterizer's. Lists
  /// compiled meanwhile are then kept, unless they change.
  bool keepsLists = false;
  Figures figures;         ///< counts from before the context was left
  std::uint64_t since = 0; ///< Counters::frames when it was left
  std::uint64_t until = 0; ///< Counters::frames when it is looked at again
  std::uint64_t patience = kLeastAlone;
  OtherTimes times;
  std::chrono::steady_clock::time_point frameEnd;
  static constexpr std::uint64_t kTimedFrames = 7;
  float timed[kTimedFrames] = {}; ///< times of the first frames
};

/// Handles a frame that was shown. A context that gains nothing loses its ContextState. One that
/// was left alone long enough may get one again.
void leaveOrReturn(RasterContext &context,
                   std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());

} // namespace arbiter::state
