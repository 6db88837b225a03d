#pragma once
#include "state/raster_draw/frames/back_off.h"
#include "state/raster_draw/frames/frame_trials.h"
#include "state/raster_draw/frames/kept_look.h"

namespace arbiter::state {

/// Holds what a context has learnt of its frames. It decides how the next frame begins.
struct FrameHistory {
  BackOff backOff;
  FrameTrials trials;
  KeptLook look;
  bool judged = false;      ///< true once a frame was judged as whole or mixed
  bool wholeFrames = false; ///< the last frames were whole, as many as `trials` asks for
  int unjudgedFrames = 0;   ///< number in a row
  /// True after mixed frames in which images were moved for few draws of the rasterizer, all of
  /// fixed function. Cleared by the next whole frame.
  bool mixesInVain = false;
  /// True in the first frame of a program that ran before: its machine code is on disk and is
  /// waited for.
  bool waitsForCode = false;
};

/// Returns the history with which a new context begins: that of the context whose frame ended last.
/// The first context begins with what the program's last start tells (functions/start_note.h).
/// Applications that make a context for each view, document or frame would otherwise never profit.
/// If contexts are of different kinds, one frame of each is misjudged.
[[nodiscard]] FrameHistory historyOfProcess();
/// Keeps the history at the end of a frame. Does nothing while another thread is in one of these
/// two functions.
void keepHistory(const FrameHistory &history);

} // namespace arbiter::state
