#pragma once
#include "state/objects/drawable.h"

/// The rasterizer's pixels shown in a window by the X server itself, from memory that both share
/// (MIT-SHM): one copy where the way through the host takes four, made while the next frame is
/// drawn. The requests go over the connection of the application's Display, so that the server
/// comes to them in the order of the application's own: what it asks for after a swap, it finds
/// shown.
namespace arbiter::interposer {

/// Says how a window shows images, where that is possible: a local server, true colour of 24 bits
/// in this machine's order. Costs a round trip or two.
/// \param display an Xlib Display
/// \param window  an X window; anything else is found out, and left alone
void offerPresenting(void *display, std::uint32_t window, state::software::Drawable &drawable);

/// state::software::WindowFrames::hostMissed of such a window.
bool hostMissedFrames(const state::software::Drawable &drawable, bool forget);

/// The display is about to be closed: no request goes to it any more.
void presentingDisplayCloses(const void *display);

} // namespace arbiter::interposer
