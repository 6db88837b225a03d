#pragma once

namespace arbiter::interposer {

/// Lets a key of the X server of $DISPLAY show and hide the HUD, if it is on (state/hud). It
/// queries the server over a connection of its own and never waits for an answer, so that an
/// application that has grabbed the server is not held up.
void offerHudKey();

} // namespace arbiter::interposer
