#include "state/software/replay.h"

#include <bit>

#include "state/context.h"
#include "state/draw.h"
#include "state/software/residency.h"

namespace arbiter::state::software {

namespace {

/// The command that sets an attribute. Three components where the fourth is the default, so that
/// the host's vertices stay small.
void tell(const host::HostTable &host, int slot, const float *v) {
  switch (slot) {
  case kPosition:
    return host.Vertex4fv(v);
  case kNormal:
    return host.Normal3fv(v);
  case kColor:
    return host.Color4fv(v);
  case kSecondary:
    return host.SecondaryColor3fv(v);
  case kFogCoord:
    return host.FogCoordfv(v);
  case kEdgeFlag:
    return host.EdgeFlag(v[0] != 0.0f ? GL_TRUE : GL_FALSE);
  default:
    if (slot >= kGeneric0)
      return host.VertexAttrib4fv(GLuint(slot - kGeneric0), v);
    return host.MultiTexCoord4fv(GLenum(GL_TEXTURE0 + slot - kTexCoord0), v);
  }
}

} // namespace

void startRecording(Context &context) {
  context.software->trueHost = context.host;
  context.host = &kRecordingHost;
  context.recordsVertices = true;
  context.insideBeginEnd = true;
}

void stopRecording(Context &context) {
  context.host = context.software->trueHost;
  context.recordsVertices = false;
}

const host::HostTable *handOver() {
  auto &context = static_cast<Context &>(*t_current);
  if (!context.recordsVertices)
    return context.host; // somebody kept the table of a moment ago
  stopRecording(context);
  context.insideBeginEnd = false; // of the host this is still true
  hostDraws(context, "glBegin");
  (void)validate(context);
  replayToHost(context);
  context.insideBeginEnd = true;
  return context.host;
}

void replayToHost(Context &context) {
  const ImmediateRecorder &recorder = context.software->recorder;
  const host::HostTable &host = *context.host;
  ++*context.drawCounter;
  host.Begin(recorder.mode());
  for (std::uint32_t i = 0; i < recorder.count(); ++i)
    recorder.read(i, [&](int slot, const float *value) { tell(host, slot, value); });
  tellCurrentValues(context);
}

void tellCurrentValues(Context &context) {
  const ImmediateRecorder &recorder = context.software->recorder;
  for (std::uint32_t left = recorder.touched(); left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    tell(*context.host, slot, recorder.values()[std::size_t(slot)].data());
  }
  if (recorder.touched() != 0)
    noteCurrent(context.software->mirror, recorder.values(), recorder.touched());
}

} // namespace arbiter::state::software
