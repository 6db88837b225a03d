// Checks before and after the host's draws: a draw with an invalid effective program is refused.
// Other commands that depend on the effective program are here too.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/era/point_sprites.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/host_assembly.h"
#include "state/host_draw/stages/application_glsl.h"
#include "state/lists/list_compiler.h"
#include "state/lists/sprite_commands.h"
#include "state/programs/program_bind.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Validates for commands that transform no vertices. A vertex program's validity does not matter
/// to them (ARB_vertex_program 2.14.4).
bool validatePixels(Context &context) {
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
void prepareListDraw(Context &context) {
  if (context.listMode != GL_COMPILE_AND_EXECUTE)
    return;
  const std::uint32_t rest = context.attention & ~attention::kList;
  if (rest == 0 || (rest == attention::kInvalid && context.hostAssembly->refuses()))
    return;
  // Validation calls the host, and these calls must not be recorded in the application's list. The
  // segment that is opened next draws with the result.
  context.list->outside(context, [] {});
}

using Validate = bool (*)(Context &);

bool begin(Context &context, Validate validateDraw) {
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
bool beginWithoutVertexShader(Context &context) {
  if (context.insideBeginEnd || context.listMode != 0)
    return begin(context, validate);
  ProgramTarget &row = context.row(Target::VertexShader);
  setEnabled(context, row, false);
  const bool valid = begin(context, validate);
  setEnabled(context, row, true); // and the next draw validates again
  return valid;
}

} // namespace

namespace handlers {

bool beginDraw(Context &context, GLenum mode) {
  if (sendParametersAlone(context)) // common: many small draws, each with its own parameters
    return true;
  issuePrimitiveMode(context, mode);
  return begin(context, validate);
}
bool beginPixels(Context &context) {
  issuePrimitiveMode(context, PointSprites::kNoPrimitive);
  return begin(context, validatePixels);
}

bool beginRasterPos(Context &context) {
  if (context.vertexShaders && context.vertexShaders->effective) [[unlikely]]
    return beginWithoutVertexShader(context);
  if (!beginDraw(context, PointSprites::kNoPrimitive))
    return false;
  // The raster position keeps all results of the vertex program, not just those that the current
  // fragment program reads.
  if (context.stagesAreLinked && !context.insideBeginEnd && context.listMode == 0) {
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

GLint RenderMode(Context &context, GLenum mode) {
  const GLint result = context.host->RenderMode(mode);
  if (context.insideBeginEnd)
    return result;
  GLint current = GL_RENDER;
  context.host->GetIntegerv(GL_RENDER_MODE, &current);
  if (context.rasterizes != (current == GL_RENDER)) {
    context.rasterizes = current == GL_RENDER;
    invalidateProgram(context);
  }
  return result;
}

void restoreApplicationProgram(Context &context) {
  if (!context.hostProgramIsOurs)
    return;
  if (context.listMode == GL_COMPILE_AND_EXECUTE)
    context.list->outside(context, [&] { releaseHostState(context); });
  else
    releaseHostState(context);
  invalidateProgram(context);
}

GLuint guardName(Context &context, GLuint name) { return guardedName(context, name); }
GLuint guardPipeline(Context &context, GLuint name) { return guardedPipeline(context, name); }

} // namespace handlers
} // namespace arbiter::state
