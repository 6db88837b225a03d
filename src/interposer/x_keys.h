#pragma once

namespace arbiter::interposer {

/// Lets a key of the X server of $DISPLAY show and hide the figures in frames, if there are any
/// (state/hud). The server is asked over a connection of its own, and no answer is waited for: an
/// application that holds the server is not held up.
void offerHudKey();

} // namespace arbiter::interposer
