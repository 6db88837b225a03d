#pragma once
#include "host/host_table.h"
#include "state/primitives/recorder.h"

/// Gives a deferred primitive to the host.
///
/// While it is recorded, ContextHot::host is kRecordingHost. A call of any of that table's
/// functions, by an entry point or by the layer's state, gives the host the primitive as far as it
/// goes. From then on the primitive is the host's. A list being compiled defers the host in the
/// same way (list_compiler.h). Commands that a recorded primitive cannot take thus need no code of
/// their own. The host reports those that are errors between Begin and End, except the common ones
/// (refused.h).
namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

extern const host::HostTable kRecordingHost;

/// Redirects the host's table to kRecordingHost, after Begin has opened the recorder.
void startRecording(RasterContext &context);
/// Restores the host's table at End. The recorder keeps its vertices.
void stopRecording(RasterContext &context);

/// Stops the recording of the thread's context, if there is one, and gives its primitive to the
/// host. Returns the real host table.
const host::HostTable *flushToHost();

/// Sends Begin, the vertices so far, and the attributes, each from where it was set. If there are
/// several primitives, the last stays open.
void sendOpen(const host::HostTable &host, const ImmediateRecorder &recorder);
/// Sends the whole primitive, including End.
void sendWhole(const host::HostTable &host, const ImmediateRecorder &recorder);
/// Opens the recorder's primitive on the host and sends its vertices so far. The host does the rest
/// of the primitive, and it counts as the host's draw. Call it after stopRecording() and
/// hostDraws().
void replayToHost(RasterContext &context);
/// Sets current values as a primitive leaves them, on the host and in the mirror (OpenGL 1.4, 2.7:
/// an attribute set inside Begin/End stays set).
void setCurrentValues(RasterContext &context, const CurrentValues &values, SlotMask touched);
/// Returns the enumerant of a material part, the same for both sides.
[[nodiscard]] GLenum materialName(int material);
/// Sets one attribute, or makes a vertex (kPosition).
/// \param components the number that the application gave; hosts compile vertex code for it
void setAttribute(const host::HostTable &host, int slot, const float value[4], int components = 4);
/// Sets the attributes of a mask.
void setAttributes(const host::HostTable &host, const CurrentValues &values, SlotMask slots);
/// Sets the attributes that were touched.
void setTouched(const host::HostTable &host, const ImmediateRecorder &recorder);

} // namespace arbiter::state
