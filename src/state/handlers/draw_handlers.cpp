// Checks before and after the host's draws: a draw with an invalid effective program is refused.
// Other commands that depend on the effective program are here too.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/era/point_sprites.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/host_draw/sprite_commands.h"
#include "state/host_draw/stages/application_glsl.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_bind.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace handlers {

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
    listCompiler(context).outside(context, [&] { releaseHostState(context); });
  else
    releaseHostState(context);
  invalidateProgram(context);
}

GLuint guardName(Context &context, GLuint name) { return guardedName(context, name); }
GLuint guardPipeline(Context &context, GLuint name) { return guardedPipeline(context, name); }

} // namespace handlers
} // namespace arbiter::state
