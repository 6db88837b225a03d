#pragma once

/// The end of a frame, as far as the rasterizer can tell one.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

/// Before the window system shows the window: residency's present(), and the frame is judged
/// (back_off.h). What showing it moves is not held against the rasterizer. True: it is shown.
[[nodiscard]] bool presentFrame(Context &context);
/// Finish, by an application that never shows a window, is the end of its frame.
void finishFrame(Context &context);

} // namespace arbiter::state::software
