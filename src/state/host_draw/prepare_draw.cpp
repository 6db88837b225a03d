#include "state/host_draw/prepare_draw.h"

#include <cstdint>

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/core/errors.h"
#include "state/era/point_sprites.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/host_draw/sprite_commands.h"
#include "state/programs/program_bind.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"

namespace arbiter::state {

namespace {

/// As validate(), for commands that transform no vertex: whether a vertex program is valid does not
/// matter to them (ARB_vertex_program 2.14.4).
bool validatePixels(Context &context) {
  if (validate(context))
    return true;
  ProgramTarget &vertex = context.row(Target::Vertex);
  if (!vertex.enabled)
    return false;
  setEnabled(context, vertex, false);
  const bool valid = validate(context);
  setEnabled(context, vertex, true); // and the next draw looks again
  return valid;
}

/// A draw while a list is compiled. COMPILE records it as it is; COMPILE_AND_EXECUTE executes it
/// too, with what was validated when the segment was opened; where that is not valid the host
/// refuses it, and records it all the same.
void prepareListDraw(Context &context) {
  if (context.listMode != GL_COMPILE_AND_EXECUTE)
    return;
  const std::uint32_t rest = context.attention & ~attention::kList;
  if (rest == 0 || (rest == attention::kInvalid && context.hostAssembly->refuses()))
    return;
  // Validation calls the host, and none of that belongs into the application's list: the segment
  // that is opened behind this has it.
  context.list->outside(context, [] {});
}

using Validate = bool (*)(Context &);

bool prepare(Context &context, Validate validateDraw) {
  if (context.passThrough || context.insideBeginEnd)
    return true; // a draw between Begin and End is the host's error to raise
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

/// As prepareDraw(): the raster position is fixed function's where a shader of EXT_vertex_shader
/// shades (2.12 of it). In a list it is what the list is called with.
bool prepareWithoutVertexShader(Context &context) {
  if (context.insideBeginEnd || context.listMode != 0)
    return prepare(context, validate);
  ProgramTarget &row = context.row(Target::VertexShader);
  setEnabled(context, row, false);
  const bool valid = prepare(context, validate);
  setEnabled(context, row, true); // and the next draw looks again
  return valid;
}

} // namespace

bool prepareDraw(Context &context, GLenum mode) {
  if (sendParametersAlone(context)) // each of many small draws has its own
    return true;
  issuePrimitiveMode(context, mode);
  return prepare(context, validate);
}

bool preparePixels(Context &context) {
  issuePrimitiveMode(context, PointSprites::kNoPrimitive);
  return prepare(context, validatePixels);
}

bool prepareRasterPos(Context &context) {
  if (context.vertexShaders && context.vertexShaders->effective) [[unlikely]]
    return prepareWithoutVertexShader(context);
  if (!prepareDraw(context, PointSprites::kNoPrimitive))
    return false;
  // The raster position keeps each result of the vertex program, whatever the fragment program in
  // force reads of them now.
  if (context.stagesAreLinked && !context.insideBeginEnd && context.listMode == 0) {
    // Mesa gathers bitmaps, and would draw them with the program that is current when it ends.
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
