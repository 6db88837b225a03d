#pragma once
#include <GL/gl.h>

/// Recognises the ends of frames, and updates the rasterizer's frame history.
namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

/// Ends a frame before the window system shows the window. Calls Residency::present() and judges
/// the frame (back_off.h). Transfers made for presenting do not count against the rasterizer.
/// Returns true if the window is shown already and the host has nothing to swap.
[[nodiscard]] bool presentFrame(RasterContext &context);
/// Handles Finish: it ends the frame of an application that never shows a window.
void finishFrame(RasterContext &context);
/// Handles a Clear that is about to be done. It ends the frame of an application that neither shows
/// a window nor calls Finish, if it clears again the target that was cleared first, with all
/// colours and depths. Nothing of an earlier pass is left in such a target. Clears of other
/// targets, or of depths alone, belong to passes of the same frame.
void clearsTarget(RasterContext &context, GLbitfield mask);

} // namespace arbiter::state
