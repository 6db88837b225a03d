#include "state/lists/conditional_commands.h"

#include "host/host_table.h"
#include "state/lists/list_compiler.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

bool keepsCommand(RasterContext &context) {
  if (context.listMode == 0 || !listCompiler(context).keeps())
    return false;
  listCompiler(context).leavePrimitive(context);
  return !context.insideBeginEnd;
}

void note(RasterContext &context, bool begun) {
  if (!context.software || context.insideBeginEnd || context.listMode == GL_COMPILE)
    return;
  context.software->mirror.conditional = begun;
  context.dirty |= dirty::kQueries;
}

} // namespace

void issueBeginConditional(RasterContext &context, GLuint id, GLenum mode) {
  if (keepsCommand(context))
    return listCompiler(context).record(
        context, {.kind = Command::Kind::BeginConditional, .target = mode, .name = id});
  // An upload is a blit, which the condition could discard. The host draws and clears until the
  // end, so nothing is pending that would need one.
  if (context.software && context.executesNow())
    context.software->residency.synchronise("glBeginConditionalRender");
  context.host->BeginConditionalRender(id, mode);
  note(context, true);
}

void issueEndConditional(RasterContext &context) {
  if (keepsCommand(context))
    return listCompiler(context).record(context, {.kind = Command::Kind::EndConditional});
  context.host->EndConditionalRender();
  note(context, false);
}

} // namespace arbiter::state
