#pragma once

/// Control and figures in the frame, as the environment asks for them.
namespace arbiter::state {

/// A context became current for the first time: what watches drawing begins, once in a process,
/// where ARBITER_CONTROL or ARBITER_HUD asks for it.
void beginWatching();

} // namespace arbiter::state
