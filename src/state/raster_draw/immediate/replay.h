#pragma once
#include "host/host_table.h"
#include "state/primitives/recorder.h"

/// A deferred primitive, and its ways to the host.
///
/// While it is recorded, ContextHot::host is kRecordingHost: what calls the host, an entry point
/// or the state tracker, by that gives it the primitive as far as it is there, and from then on it
/// is the host's. A list that is compiled defers the host in the same way (list_compiler.h). So
/// commands that a recorded primitive cannot take need no code of their own. Those that are errors
/// between Begin and End are judged by the host, but for the common ones (refused.h).
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

extern const host::HostTable kRecordingHost;

/// Begin was called and draw.h's begin() has opened the recorder.
void startRecording(Context &context);
/// End was called: commands go to the host again. The recorder is as it was.
void stopRecording(Context &context);

/// Of the thread's context: stops recording where it records, and gives the host what there is of
/// the primitive. Returns the host's own table.
const host::HostTable *flushToHost();

/// Begin, the vertices so far and what the attributes are now: each is sent from where it was set.
/// Of several primitives the last is open.
void sendOpen(const host::HostTable &host, const ImmediateRecorder &recorder);
/// The whole primitive.
void sendWhole(const host::HostTable &host, const ImmediateRecorder &recorder);
/// After stopRecording() and hostDraws(): opens the recorder's primitive on the host and sends all
/// its vertices so far, each attribute from where it was set. What follows in the primitive is the
/// host's. It is counted as a draw of the host's.
void replayToHost(Context &context);
/// The host's current values become those that a primitive left behind (OpenGL 1.4, 2.7: an
/// attribute set inside Begin/End stays set), and the mirror's with them.
void setCurrentValues(Context &context, const CurrentValues &values, SlotMask touched);
/// The name of a part of a material, of either side.
[[nodiscard]] GLenum materialName(int material);
/// Sets one attribute, or makes a vertex (kPosition). \param components as many of the four as the
/// application gives: hosts compile vertex code for the components that they are given
void setAttribute(const host::HostTable &host, int slot, const float value[4], int components = 4);
/// Those of a mask.
void setAttributes(const host::HostTable &host, const CurrentValues &values, SlotMask slots);
/// Those that were touched.
void setTouched(const host::HostTable &host, const ImmediateRecorder &recorder);

} // namespace arbiter::state::software
