#pragma once

/// Starts control and the figures in the frame, as the environment asks for.
namespace arbiter::state {

/// Starts what watches drawing, once per process, if ARBITER_CONTROL or ARBITER_HUD asks for it.
/// Called when a context is current for the first time.
void beginWatching();

} // namespace arbiter::state
