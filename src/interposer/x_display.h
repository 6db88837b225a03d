#pragma once

/// Handles the closing of an application's Display. Contexts that it leaves behind are then gone,
/// and no request may follow.
namespace arbiter::interposer {

/// Asks Xlib to report when the display is closed; a second call does nothing. The layer's own
/// connection closes now, as the application has one.
/// \param display an Xlib Display; null does nothing
void watchDisplay(void *display);

} // namespace arbiter::interposer
