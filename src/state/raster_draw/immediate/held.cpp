#include "state/raster_draw/immediate/held.h"

#include "state/core/memory.h"
#include "state/host_draw/native_inputs.h"
#include "state/mirror/dirty_bits.h"
#include "state/primitives/geometry.h"
#include "state/primitives/joined.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/immediate/primitive.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

/// Passes a vertex outside of Begin and End to the host, which ignores it.
bool vertexOutside(void *owner, const float position[4]) {
  auto &context = *static_cast<RasterContext *>(owner);
  drawHeld(context);
  context.dirty |= dirty::kCurrent;
  setAttribute(*context.host, kPosition, position);
  return false;
}

} // namespace

bool holdPrimitive(RasterContext &context) {
  ContextState &state = *context.software;
  ImmediateRecorder &recorder = state.recorder;
  if (context.recorder != &recorder || state.openParts || recorder.failed())
    return false;
  const std::uint32_t size = independentVertices(recorder.mode());
  const std::uint32_t count = recorder.count();
  if (count == 0 || count > kMaxHeld || (size != 0 && count % size != 0))
    return false;
  if (size == 0 && !joiningOf(state.mirror.raster, recorder.mode()))
    return false;
  recorder.limit(count, vertexOutside, &context);
  ++state.held;
  context.attention |= attention::kHeld;
  context.insideBeginEnd = false;
  return true;
}

bool reopenHeld(RasterContext &context, GLenum mode) {
  ContextState &state = *context.software;
  if (mode != state.recorder.mode()) {
    drawHeld(context);
    return false;
  }
  if (independentVertices(mode) == 0 && !openNext(context)) {
    drawHeld(context);
    return false;
  }
  context.attention &= ~attention::kHeld;
  context.insideBeginEnd = true;
  if (independentVertices(mode) != 0)
    limitOpen(context);
  return true;
}

void drawHeld(ContextHot &hot) {
  auto &context = rasterStep(hot);
  const ImmediateInputs inputs(context);
  stopRecording(context);
  withinMemory(context, "End", [&] { endHeld(context); });
}

const host::HostTable *answeringHost(ContextHot &hot) {
  const bool standsIn = hot.listMode != 0 && hot.host == &kRecordingHost;
  return standsIn ? rasterStep(hot).trueHost : hot.host;
}

} // namespace arbiter::state
