#pragma once
#include "state/objects/drawable.h"

/// Tracks frames that the layer presents without the host. After such a frame the host must look
/// for a new window size, as it would at its own swap.
namespace arbiter::state {

/// The functions, which the interposer implements. They take drawables with `show`.
struct WindowFrames {
  /// True if show() was called since the last query with `forget`, in any context.
  bool (*hostMissed)(const Drawable &drawable, bool forget) = nullptr;
  /// Makes the host swap buffers. Its back buffer holds the presented frame.
  void (*swapHost)(const Drawable &drawable) = nullptr;
};
/// Sets the functions, once, before the first context is made.
void setWindowFrames(const WindowFrames &frames);
[[nodiscard]] const WindowFrames &windowFrames();

} // namespace arbiter::state
