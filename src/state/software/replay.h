#pragma once

/// A primitive that was kept back from the host, given to it after all.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

/// Opens the recorder's primitive on the host and sends all its vertices so far, each attribute
/// from where it was set. What follows in the primitive is the host's.
void replayToHost(Context &context);
/// The host's current values become those that the recorded primitive left behind (OpenGL 1.4, 2.7:
/// an attribute set inside Begin/End stays set), and the mirror's with them.
void tellCurrentValues(Context &context);

} // namespace arbiter::state::software
