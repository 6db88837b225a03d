#include "state/raster_draw/immediate/split.h"

#include "host/host_table.h"
#include "state/core/memory.h"
#include "state/primitives/geometry.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/immediate/primitive.h"
#include "state/raster_draw/immediate/primitive_materials.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

bool endsHere(const ImmediateRecorder &recorder) {
  const std::uint32_t vertices = independentVertices(recorder.mode());
  return recorder.lastCount() == 0 || (vertices != 0 && recorder.count() % vertices == 0);
}

} // namespace

void PrimitiveSplit::open(ContextHot &hot) {
  auto &context = rasterStep(hot);
  if (context.listMode != 0 || context.recorder != &context.software->recorder)
    return;
  const ContextState &state = *context.software;
  if (state.openParts || state.recorder.failed() || !endsHere(state.recorder))
    return;
  m_hot = &hot;
  m_mode = state.recorder.mode();
  stopRecording(context);
  context.insideBeginEnd = false;
  withinMemory(context, "glMaterial", [&] {
    if (state.recorder.count() != 0)
      endPrimitive(context);
    else
      setCurrentValues(context, state.recorder.values(), slotsToSet(context));
  });
}

void PrimitiveSplit::close() {
  auto &context = rasterStep(*m_hot);
  bool isRecorded = false;
  withinMemory(context, "glMaterial",
               [&] { isRecorded = usesRasterizer(context) && beginPrimitive(context, m_mode); });
  if (isRecorded)
    return startRecording(context);
  ++*context.drawCounter;
  context.host->Begin(m_mode);
  context.insideBeginEnd = true;
}

} // namespace arbiter::state
