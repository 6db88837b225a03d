#pragma once
#include "state/raster_draw/frames/back_off.h"
#include "state/raster_draw/frames/frame_trials.h"
#include "state/raster_draw/frames/kept_look.h"

namespace arbiter::state::software {

/// What a context has learnt of its frames, by which the next one is begun.
struct FrameHistory {
  BackOff backOff;
  FrameTrials trials;
  KeptLook look;
  bool judged = false; ///< of a frame it was said whether it is a whole one
  bool wholeFrames =
      false;              ///< the last frames had no turn of the host, as many as `trials` asks for
  int unjudgedFrames = 0; ///< in a row
  /// The last frames were mixed ones, in which the rasterizer drew little beside the host, by fixed
  /// function alone, and images were moved for it: not until a frame is a whole one again.
  bool mixesInVain = false;
  /// The first frame of a program that ran before: its machine code is on disk, and waited for.
  bool waitsForCode = false;
};

/// The history that a context begins with: that of the context of this process whose frame ended
/// last, or, of the first one, what the program's last start tells (functions/start_note.h).
/// Applications that make a context for each view, document or even frame
/// would never be drawn by what their frames are; an application of several kinds of contexts has
/// one frame of each judged by another's.
[[nodiscard]] FrameHistory historyOfProcess();
/// At the end of a frame. Does nothing while another thread is in one of these two.
void keepHistory(const FrameHistory &history);

} // namespace arbiter::state::software
