#include "state/host_draw/prepare_draw.h"

#include <cstdint>

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/era/point_sprites.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/host_draw/sprite_commands.h"
#include "state/programs/program_bind.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"

namespace arbiter::state {

namespace {

/// Validates for commands that transform no vertices. A vertex program's validity does not matter
/// to them (ARB_vertex_program 2.14.4).
bool validatePixels(DrawContext &context) {
  if (validate(context))
    return true;
  ProgramTarget &vertex = context.row(Target::Vertex);
  if (!vertex.enabled)
    return false;
  setEnabled(context, vertex, false);
  const bool valid = validate(context);
  setEnabled(context, vertex, true); // and the next draw validates again
  return valid;
}

/// Prepares a draw while a list is compiled. COMPILE just records it. COMPILE_AND_EXECUTE also
/// executes it, with the state that was validated when the segment was opened. If that is invalid
/// the host refuses the draw, and still records it.
void prepareListDraw(DrawContext &context) {
  if (context.listMode != GL_COMPILE_AND_EXECUTE)
    return;
  const std::uint32_t rest = context.attention & ~attention::kList;
  if (rest == 0 || (rest == attention::kInvalid && context.hostSide.assembly->refuses()))
    return;
  // Validation calls the host, and these calls must not be recorded in the application's list. The
  // segment that is opened next draws with the result.
  context.list->outside(context, [] {});
}

using Validate = bool (*)(DrawContext &);

bool prepare(DrawContext &context, Validate validateDraw) {
  if (context.passThrough || context.insideBeginEnd)
    return true; // a draw between Begin and End: the host raises the error
  if (context.listMode) {
    prepareListDraw(context);
    return true;
  }
  if (validateDraw(context)) [[likely]]
    return true;
  ++*context.drawCounter;
  raise(context, GL_INVALID_OPERATION, "draw: an effective program is not valid");
  return false;
}

/// Prepares RasterPos with fixed function in place of a shader of EXT_vertex_shader (2.12 of it).
/// In a list the state of the call counts.
bool prepareWithoutVertexShader(DrawContext &context) {
  if (context.insideBeginEnd || context.listMode != 0)
    return prepare(context, validate);
  ProgramTarget &row = context.row(Target::VertexShader);
  setEnabled(context, row, false);
  const bool valid = prepare(context, validate);
  setEnabled(context, row, true); // and the next draw validates again
  return valid;
}

} // namespace

bool prepareDraw(DrawContext &context, GLenum mode) {
  if (sendParametersAlone(context)) // common: many small draws, each with its own parameters
    return true;
  issuePrimitiveMode(context, mode);
  return prepare(context, validate);
}

bool preparePixels(DrawContext &context) {
  issuePrimitiveMode(context, PointSprites::kNoPrimitive);
  return prepare(context, validatePixels);
}

bool prepareRasterPos(DrawContext &context) {
  if (context.vertexShaders && context.vertexShaders->effective) [[unlikely]]
    return prepareWithoutVertexShader(context);
  if (!prepareDraw(context, PointSprites::kNoPrimitive))
    return false;
  // The raster position keeps all results of the vertex program, not just those that the current
  // fragment program reads.
  if (context.stagesAreLinked && context.executesNow()) {
    // Mesa defers bitmaps, and would draw them with a later program.
    context.host->Flush();
    context.vertexResultsMatter = true;
    invalidateProgram(context);
    (void)validate(context);
    context.vertexResultsMatter = false;
    invalidateProgram(context);
  }
  return true;
}

} // namespace arbiter::state
