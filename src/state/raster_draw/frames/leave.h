#pragma once
#include <chrono>
#include <cstdint>

#include "state/raster_draw/frames/other_times.h"
#include "state/raster_draw/report.h"

/// Contexts that gain nothing: where a window has several samples a pixel every draw is refused for
/// its target, and where something in each frame is the host's alone most others are the host's
/// for its sake, while all state is followed, and lists are kept in pieces. Such a context is left
/// to the host.
namespace arbiter::state::software {

/// Frames in which every draw was refused for its target, until the context is left alone.
inline constexpr int kRefusedFrames = 8;
/// Frames in which the rasterizer drew nothing, as it lacks what some of their draws need.
inline constexpr int kGainlessFrames = 8;
/// The same of one that was left alone before, and gained nothing since.
inline constexpr int kRefusedAgain = 2;
/// Frames until one that is left alone is looked at again, as it may draw elsewhere by then.
inline constexpr std::uint64_t kFramesAlone = 1000;
/// The same where its frames take another time than when it was left, as behind a title; twice as
/// many after each time that it gained nothing all the same.
inline constexpr std::uint64_t kLeastAlone = 32;

struct LeftAlone {
  /// Draws of the current ContextState at the end of the last frame.
  struct Seen {
    std::uint64_t drawn = 0;
    std::uint64_t refused = 0; ///< for their target
    std::uint64_t others = 0;  ///< refused for another reason, but that the host keeps a list
    std::uint64_t lists = 0;   ///< that the host keeps
    /// Part of `others` that says nothing: a neighbour may be gone, and code there, in a moment.
    std::uint64_t passing = 0;
  };
  Seen seen;
  int refusedFrames = 0;  ///< in a row, whose draws were all refused for their target
  int gainlessFrames = 0; ///< in a row, whose draws were the host's, as the rasterizer lacks some
  int mostGainless = kGainlessFrames;
  bool before = false;  ///< the context was left alone once
  bool returns = false; ///< it is to have a ContextState, with its next draw
  /// Other draws than to a target that the rasterizer lacks may be its own one day: lists that are
  /// compiled meanwhile are to be kept, but for those that change.
  bool keepsLists = false;
  Figures figures;         ///< of what was drawn and refused before
  std::uint64_t since = 0; ///< Context::frames at which it was left
  std::uint64_t until = 0; ///< and those at which it is looked at again
  std::uint64_t patience = kLeastAlone;
  OtherTimes times;
  std::chrono::steady_clock::time_point frameEnd;
  static constexpr std::uint64_t kTimedFrames = 7;
  float timed[kTimedFrames] = {}; ///< the first frames' times
};

/// Behind a frame that was shown: a context that gains nothing loses its ContextState, and one that
/// was left alone long enough may have one again.
void leaveOrReturn(Context &context,
                   std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());

} // namespace arbiter::state::software
