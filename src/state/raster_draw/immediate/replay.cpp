#include "state/raster_draw/immediate/replay.h"

#include <array>
#include <bit>

#include "state/core/memory.h"
#include "state/host_draw/draw.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"
#include "util/numbers/same_bits.h"

namespace arbiter::state {

GLenum materialName(int material) {
  constexpr std::array<GLenum, std::size_t(kMaterialParts)> kNames = {
      GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_SHININESS};
  return kNames[std::size_t(material % kMaterialParts)];
}

namespace {

void setMaterial(const host::HostTable &host, int material, const float *v) {
  host.Materialfv(material < kMaterialParts ? GL_FRONT : GL_BACK, materialName(material), v);
}

/// Remembers the materials sent last, so that unchanged ones are not sent again.
class SentMaterials {
public:
  [[nodiscard]] bool areSent(int material, const float *value) {
    const float *&last = m_last[std::size_t(material)];
    if (last && sameBytes(last, value, 4 * sizeof(float)))
      return true;
    last = value;
    return false;
  }

private:
  std::array<const float *, std::size_t(2 * kMaterialParts)> m_last{};
};

/// Updates the mirror after the host was given current values.
void noteSet(RasterContext &context, const CurrentValues &values, SlotMask slots) {
  if (materialsIn(slots) != 0) [[unlikely]]
    context.dirty |= dirty::kMaterial | dirty::kProgramState;
  if (context.software)
    context.software->mirror.noteCurrent(values, std::uint32_t(slots));
}

} // namespace

void setAttribute(const host::HostTable &host, int slot, const float *v, int components) {
  // Selects the host's function by the number of components.
  const auto take = [&](auto two, auto three, auto four) {
    return (components == 2 ? two : components == 3 ? three : four)(v);
  };
  const auto takeIndexed = [&](auto index, auto one, auto two, auto three, auto four) {
    return (components == 1   ? one
            : components == 2 ? two
            : components == 3 ? three
                              : four)(index, v);
  };
  switch (slot) {
  case kPosition:
    return take(host.Vertex2fv, host.Vertex3fv, host.Vertex4fv);
  case kNormal:
    return host.Normal3fv(v);
  case kColor:
    return components == 3 ? host.Color3fv(v) : host.Color4fv(v);
  case kSecondary:
    return host.SecondaryColor3fv(v);
  case kFogCoord:
    return host.FogCoordfv(v);
  case kEdgeFlag:
    return host.EdgeFlag(v[0] != 0.0f ? GL_TRUE : GL_FALSE);
  default:
    if (slot >= kMaterial0)
      return setMaterial(host, slot - kMaterial0, v);
    if (slot >= kGeneric0)
      return takeIndexed(GLuint(slot - kGeneric0), host.VertexAttrib1fv, host.VertexAttrib2fv,
                         host.VertexAttrib3fv, host.VertexAttrib4fv);
    return takeIndexed(GLenum(GL_TEXTURE0 + slot - kTexCoord0), host.MultiTexCoord1fv,
                       host.MultiTexCoord2fv, host.MultiTexCoord3fv, host.MultiTexCoord4fv);
  }
}

void startRecording(RasterContext &context) {
  context.trueHost = context.host;
  context.host = &kRecordingHost;
  context.recorder = &context.software->recorder;
  context.attention |= attention::kRecorded;
  context.insideBeginEnd = true;
}

void stopRecording(RasterContext &context) {
  context.attention &= ~(attention::kHeld | attention::kRecorded);
  context.host = context.trueHost;
  context.recorder = nullptr;
}

const host::HostTable *flushToHost() {
  auto &context = rasterStep(*t_current);
  if (context.host != &kRecordingHost)
    return context.host; // the caller holds a pointer to the table of a moment ago
  if (context.listMode != 0) {
    context.list->giveHost(context);
    return context.host;
  }
  // This is no command, because commands draw held primitives first.
  const bool hasEnded = (context.attention & attention::kHeld) != 0;
  stopRecording(context);
  context.insideBeginEnd = false; // on the host, no primitive is open yet
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

void setAttributes(const host::HostTable &host, const CurrentValues &values, SlotMask slots) {
  for (SlotMask left = slots; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    setAttribute(host, slot, values[std::size_t(slot)].data());
  }
}

void setTouched(const host::HostTable &host, const ImmediateRecorder &recorder) {
  for (SlotMask left = recorder.touched(); left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    setAttribute(host, slot, recorder.values()[std::size_t(slot)].data(),
                 mostGiven(recorder.given(), slot));
  }
}

void sendOpen(const host::HostTable &host, const ImmediateRecorder &recorder) {
  host.Begin(recorder.mode());
  std::uint32_t at = 0;
  SentMaterials materials;
  const auto sendTo = [&](std::uint32_t end) {
    for (; at < end; ++at)
      recorder.read(at, [&](int slot, const float *value) {
        if (slot >= kMaterial0 && materials.areSent(slot - kMaterial0, value))
          return;
        setAttribute(host, slot, value, mostGiven(recorder.given(), slot));
      });
  };
  for (const std::uint32_t start : recorder.starts()) {
    sendTo(start);
    host.End();
    host.Begin(recorder.mode());
  }
  sendTo(recorder.count());
  setTouched(host, recorder);
}

void sendWhole(const host::HostTable &host, const ImmediateRecorder &recorder) {
  sendOpen(host, recorder);
  host.End();
}

void replayToHost(RasterContext &context) {
  const ImmediateRecorder &recorder = context.software->recorder;
  *context.drawCounter += 1 + recorder.starts().size();
  sendOpen(*context.host, recorder);
  noteSet(context, recorder.values(), recorder.touched());
}

void setCurrentValues(RasterContext &context, const CurrentValues &values, SlotMask touched) {
  setAttributes(*context.host, values, touched);
  if (touched != 0)
    noteSet(context, values, touched);
}

} // namespace arbiter::state
