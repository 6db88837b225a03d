#include "state/lists/primitive_commands.h"

#include "host/host_table.h"
#include "state/host_draw/evaluators/evaluation.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/host_draw/native_inputs.h"
#include "state/host_draw/prepare_draw.h"
#include "state/lists/list_compiler.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/immediate/held.h"
#include "state/raster_draw/immediate/primitive.h"
#include "state/raster_draw/immediate/refused.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

/// Starts to record the primitive for the rasterizer. Returns false if the host draws it.
bool defer(RasterContext &context, GLenum mode) {
  if (mode > GL_POLYGON || context.insideBeginEnd || context.listMode != 0)
    return false;
  if (!usesRasterizer(context) || !beginPrimitive(context, mode))
    return false;
  startRecording(context);
  return true;
}

} // namespace

void issueBegin(RasterContext &context, GLenum mode) {
  if (isHeld(context) && reopenHeld(context, mode))
    return;
  if (isRecorded(context) && refuses(context, "glBegin")) [[unlikely]]
    return;
  const ImmediateInputs inputs(context);
  if (context.mapsNamed) [[unlikely]]
    beginEvaluation(context);
  if (context.listMode != 0) {
    if (listCompiler(context).recordsPrimitive())
      listCompiler(context).givePrimitive(context);
    else if (listCompiler(context).beginPrimitive(context, mode))
      return;
  }
  if (mayDraw(context) && defer(context, mode))
    return;
  if (context.attention && !prepareDraw(context, mode)) [[unlikely]]
    return;
  ++*context.drawCounter;
  if (context.listMode)
    listCompiler(context).notePixels();
  context.host->Begin(mode);
  if (mode > GL_POLYGON)
    return; // begins no primitive
  if (context.listMode)
    listCompiler(context).notePrimitive(Primitive::Open);
  if (context.listMode != GL_COMPILE && !context.hostSide.assembly->refuses())
    context.insideBeginEnd = true;
}

void issueEnd(RasterContext &context) {
  if (isHeld(context)) [[unlikely]] // an End without Begin, which is an error
    drawHeld(context);
  if (context.recorder && context.listMode == 0 && holdPrimitive(context))
    return;
  const ImmediateInputs inputs(context);
  if (context.listMode != 0 && listCompiler(context).recordsPrimitive())
    return listCompiler(context).endPrimitive(context);
  if (context.recorder && context.listMode == 0) {
    stopRecording(context);
    context.insideBeginEnd = false;
    return endPrimitive(context);
  }
  if (context.listMode)
    listCompiler(context).notePixels();
  context.host->End();
  if (context.listMode)
    listCompiler(context).notePrimitive(Primitive::Closed);
  if (context.listMode != GL_COMPILE)
    context.insideBeginEnd = false;
}

} // namespace arbiter::state
