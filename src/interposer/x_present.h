#pragma once
#include "state/objects/drawable.h"

/// Shows the rasterizer's pixels in a window by the X server itself, from shared memory (MIT-SHM).
/// It takes one copy, made while the next frame is drawn, instead of the four through the host. The
/// requests use the connection of the application's Display, so that the server handles them in
/// order with the application's own: a request after a swap sees the new frame.
namespace arbiter::interposer {

/// Lets a window show images directly if possible: with a local server and 24-bit true color in
/// this machine's byte order. Costs a round trip or two.
/// \param display an Xlib Display
/// \param window  an X window; anything else is detected and ignored
void offerPresenting(void *display, std::uint32_t window, state::Drawable &drawable);

/// Implements state::WindowFrames::hostMissed for such a window.
bool hostMissedFrames(const state::Drawable &drawable, bool forget);

/// Called before the display is closed: no more requests are sent to it.
void presentingDisplayCloses(const void *display);

} // namespace arbiter::interposer
