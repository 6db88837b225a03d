#pragma once
#include "state/objects/drawable.h"

/// Frames that the layer shows without the host, and what the host must find out of them: that the
/// window has another size since, as it would have at its own swap.
namespace arbiter::state::software {

/// Of drawables with `show`; the interposer's.
struct WindowFrames {
  /// True since show(), whichever context it was called by, until it is asked with `forget`.
  bool (*hostMissed)(const Drawable &drawable, bool forget) = nullptr;
  /// The host swaps buffers. Its back buffer is to hold what is shown.
  void (*swapHost)(const Drawable &drawable) = nullptr;
};
/// Before the first context; once.
void setWindowFrames(const WindowFrames &frames);
[[nodiscard]] const WindowFrames &windowFrames();

} // namespace arbiter::state::software
