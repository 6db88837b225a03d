#pragma once

/// The end of an application's Display. Contexts that it leaves behind are gone then, and no
/// request may follow.
namespace arbiter::interposer {

/// Asks Xlib to say when the display is closed; once asked, does nothing.
/// \param display an Xlib Display; null does nothing
void watchDisplay(void *display);

} // namespace arbiter::interposer
