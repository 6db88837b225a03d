#include "state/raster_draw/immediate/replay.h"

#include <bit>
#include <cmath>

#include "state/core/context.h"
#include "state/core/memory.h"
#include "state/host_draw/draw.h"
#include "state/lists/list_compiler.h"
#include "state/raster_draw/context_state.h"

namespace arbiter::state::software {

/// The command that sets an attribute. Three components where the fourth is the default, so that
/// the host's vertices stay small.
void setAttribute(const host::HostTable &host, int slot, const float *v) {
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

void startRecording(Context &context) {
  context.trueHost = context.host;
  context.host = &kRecordingHost;
  context.recorder = &context.software->recorder;
  context.insideBeginEnd = true;
}

void stopRecording(Context &context) {
  context.attention &= ~attention::kHeld;
  context.host = context.trueHost;
  context.recorder = nullptr;
}

const host::HostTable *flushToHost() {
  auto &context = static_cast<Context &>(*t_current);
  if (context.host != &kRecordingHost)
    return context.host; // the caller kept the table of a moment ago
  if (context.listMode != 0) {
    context.list->giveHost(context);
    return context.host;
  }
  const bool hasEnded =
      (context.attention & attention::kHeld) != 0; // no command, as those have it drawn first
  stopRecording(context);
  context.insideBeginEnd = false; // of the host this is still true
  withinMemory(context, "glBegin", [&] {
    context.software->hostDraws("glBegin");
    (void)validate(context);
  });
  replayToHost(context);
  if (hasEnded)
    context.host->End();
  context.insideBeginEnd = !hasEnded;
  return context.host;
}

void setAttributes(const host::HostTable &host, const CurrentValues &values, std::uint32_t slots) {
  for (std::uint32_t left = slots; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    setAttribute(host, slot, values[std::size_t(slot)].data());
  }
}

void sendOpen(const host::HostTable &host, const ImmediateRecorder &recorder) {
  host.Begin(recorder.mode());
  std::uint32_t at = 0;
  const auto sendTo = [&](std::uint32_t end) {
    for (; at < end; ++at)
      recorder.read(at, [&](int slot, const float *value) { setAttribute(host, slot, value); });
  };
  for (const std::uint32_t start : recorder.starts()) {
    sendTo(start);
    host.End();
    host.Begin(recorder.mode());
  }
  sendTo(recorder.count());
  setAttributes(host, recorder.values(), recorder.touched());
}

void sendWhole(const host::HostTable &host, const ImmediateRecorder &recorder) {
  const auto set = [&](int slot, const float *v) {
    const bool isTexCoord = slot >= kTexCoord0 && slot < kGeneric0;
    if (slot == kPosition && v[3] == 1.0f)
      return host.Vertex3fv(v);
    if (isTexCoord && v[3] == 1.0f && v[2] == 0.0f && !std::signbit(v[2]))
      return host.MultiTexCoord2fv(GLenum(GL_TEXTURE0 + slot - kTexCoord0), v);
    setAttribute(host, slot, v);
  };
  host.Begin(recorder.mode());
  for (std::uint32_t i = 0; i < recorder.count(); ++i)
    recorder.read(i, set);
  setAttributes(host, recorder.values(), recorder.touched());
  host.End();
}

void replayToHost(Context &context) {
  const ImmediateRecorder &recorder = context.software->recorder;
  *context.drawCounter += 1 + recorder.starts().size();
  sendOpen(*context.host, recorder);
  context.software->mirror.noteCurrent(recorder.values(), recorder.touched());
}

void setCurrentValues(Context &context, const CurrentValues &values, std::uint32_t touched) {
  setAttributes(*context.host, values, touched);
  if (touched != 0 && context.software)
    context.software->mirror.noteCurrent(values, touched);
}

} // namespace arbiter::state::software
