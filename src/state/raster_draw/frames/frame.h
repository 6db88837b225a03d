#pragma once
#include <GL/gl.h>

/// The end of a frame, as far as the rasterizer can tell one.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

/// Before the window system shows the window: residency's present(), and the frame is judged
/// (back_off.h). Transfers that presenting makes do not
/// count against the rasterizer. True: it is shown.
[[nodiscard]] bool presentFrame(Context &context);
/// Finish, by an application that never shows a window, is the end of its frame.
void finishFrame(Context &context);
/// Before Clear. Of an application that neither shows a window nor calls Finish a frame ends where
/// the target that it cleared first is cleared again, as a whole and in all its colours and depths:
/// no earlier pass is left in it. Clears of other targets, for passes of the same frame, and of
/// depths alone end none.
void clearsTarget(Context &context, GLbitfield mask);

} // namespace arbiter::state::software
