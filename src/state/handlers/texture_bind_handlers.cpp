// Commands that bind textures, except for PopAttrib and deletions.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/lists/state_commands.h"
#include "state/lists/texture_commands.h"

namespace arbiter::state::handlers {

void BindTexture(Context &context, GLenum target, GLuint texture) {
  if (context.listMode != 0 && recordBindTexture(context, target, texture))
    return;
  context.host->BindTexture(target, texture);
  noteTextureCommand(context);
}

void BindTextures(Context &context, GLuint first, GLsizei count, const GLuint *textures) {
  context.host->BindTextures(first, count, textures);
  noteTextureCommand(context);
}

void BindTextureUnit(Context &context, GLuint unit, GLuint texture) {
  context.host->BindTextureUnit(unit, texture);
  noteTextureCommand(context);
}

void BindMultiTextureEXT(Context &context, GLenum texunit, GLenum target, GLuint texture) {
  context.host->BindMultiTextureEXT(texunit, target, texture);
  noteTextureCommand(context);
}

} // namespace arbiter::state::handlers
