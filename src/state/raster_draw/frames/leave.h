#pragma once
#include <cstdint>

#include "state/raster_draw/report.h"

/// Contexts that gain nothing: where a window has several samples a pixel, every draw is refused
/// for its target while all state is followed. Such a context is left to the host.
namespace arbiter::state::software {

/// Frames in which every draw was refused so, until the context is left alone.
inline constexpr int kRefusedFrames = 8;
/// The same of one that was left alone before.
inline constexpr int kRefusedAgain = 2;
/// Frames until one that is left alone is looked at again, as it may draw elsewhere by then.
inline constexpr std::uint64_t kFramesAlone = 1000;

struct LeftAlone {
  /// Draws of the current ContextState at the end of the last frame: refused for their target, and
  /// all others.
  std::uint64_t refusedSeen = 0, othersSeen = 0;
  int refusedFrames = 0;   ///< in a row, whose draws were all refused so
  bool before = false;     ///< the context was left alone once
  Figures figures;         ///< of what was drawn and refused before
  std::uint64_t until = 0; ///< Context::frames at which it is looked at again
};

/// Behind a frame that was shown: a context whose draws are all refused loses its ContextState, and
/// one that was left alone long enough may have one again.
void leaveOrReturn(Context &context);

} // namespace arbiter::state::software
