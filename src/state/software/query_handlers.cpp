// Conditional rendering, which cannot be asked for. One that the host refuses is taken for begun:
// until its end draws are the host's, which is always right.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context.h"

namespace arbiter::state::handlers {

namespace {

void note(Context &context, bool begun) {
  if (!context.software || context.insideBeginEnd || context.listMode == GL_COMPILE)
    return;
  context.software->mirror.conditional = begun;
  context.stale |= software::stale::kQueries;
}

} // namespace

void BeginConditionalRender(Context &context, GLuint id, GLenum mode) {
  context.host->BeginConditionalRender(id, mode);
  note(context, true);
}

void EndConditionalRender(Context &context) {
  context.host->EndConditionalRender();
  note(context, false);
}

} // namespace arbiter::state::handlers
