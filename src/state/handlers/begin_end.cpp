// Begin and End: a primitive goes to the host vertex by vertex, or is recorded for the rasterizer.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/core/context.h"
#include "state/host_draw/evaluators/evaluation.h"
#include "state/host_draw/host_assembly.h"
#include "state/host_draw/native_inputs.h"
#include "state/lists/list_compiler.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/immediate/held.h"
#include "state/raster_draw/immediate/list_arrays.h"
#include "state/raster_draw/immediate/primitive.h"
#include "state/raster_draw/immediate/refused.h"
#include "state/raster_draw/immediate/replay.h"

namespace arbiter::state {

namespace {

/// Starts to record the primitive for the rasterizer. Returns false if the host draws it.
bool defer(Context &context, GLenum mode) {
  if (mode > GL_POLYGON || context.insideBeginEnd || context.listMode != 0)
    return false;
  if (!software::usesRasterizer(context) || !software::beginPrimitive(context, mode))
    return false;
  software::startRecording(context);
  return true;
}

} // namespace

namespace handlers {

void Begin(Context &context, GLenum mode) {
  if (software::isHeld(context) && software::reopenHeld(context, mode))
    return;
  if (software::isRecorded(context) && software::refuses(context, "glBegin")) [[unlikely]]
    return;
  const ImmediateInputs inputs(context);
  if (context.mapsNamed) [[unlikely]]
    beginEvaluation(context);
  if (context.listMode != 0) {
    if (context.list->recordsPrimitive())
      context.list->givePrimitive(context);
    else if (context.list->beginPrimitive(context, mode))
      return;
  }
  if (software::mayDraw(context) && defer(context, mode))
    return;
  if (context.attention && !beginDraw(context, mode)) [[unlikely]]
    return;
  ++*context.drawCounter;
  if (context.listMode)
    context.list->notePixels();
  context.host->Begin(mode);
  if (mode > GL_POLYGON)
    return; // begins no primitive
  if (context.listMode)
    context.list->notePrimitive(Primitive::Open);
  if (context.listMode != GL_COMPILE && !context.hostAssembly->refuses())
    context.insideBeginEnd = true;
}

void End(Context &context) {
  if (software::isHeld(context)) [[unlikely]] // an End without Begin, which is an error
    software::drawHeld(context);
  if (context.recorder && context.listMode == 0 && software::holdPrimitive(context))
    return;
  const ImmediateInputs inputs(context);
  if (context.listMode != 0 && context.list->recordsPrimitive())
    return context.list->endPrimitive(context);
  if (context.recorder && context.listMode == 0) {
    software::stopRecording(context);
    context.insideBeginEnd = false;
    return software::endPrimitive(context);
  }
  if (context.listMode)
    context.list->notePixels();
  context.host->End();
  if (context.listMode)
    context.list->notePrimitive(Primitive::Closed);
  if (context.listMode != GL_COMPILE)
    context.insideBeginEnd = false;
}

void ArrayElement(Context &context, GLint index) {
  if (!software::recordElement(context, index))
    context.host->ArrayElement(index);
}

} // namespace handlers
} // namespace arbiter::state
