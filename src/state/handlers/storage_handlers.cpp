// Commands after which objects have storage in common, and those that delete such objects: what the
// other contexts of the group must know. So these come here in contexts too that are the host's
// otherwise (`everywhere` in entry_points.toml), and in none at all.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/core/context.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"
#include "state/share/neighbours.h"
#include "state/share/share_group.h"

namespace arbiter::state::handlers {

void TextureView(Context &context, GLuint texture, GLenum target, GLuint origtexture,
                 GLenum internalformat, GLuint minlevel, GLuint numlevels, GLuint minlayer,
                 GLuint numlayers) {
  if (context.softwareListens)
    software::hostDoesUnknown(context, "glTextureView");
  if (context.group)
    context.group->textureViews.add(texture, origtexture);
  context.host->TextureView(texture, target, origtexture, internalformat, minlevel, numlevels,
                            minlayer, numlayers);
}

/// Textures and buffers of such memory change with each other, and by the process that exported it.
void ImportMemoryFdEXT(Context &context, GLuint memory, GLuint64 size, GLenum handleType,
                       GLint fd) {
  if (context.softwareListens)
    software::hostDoesUnknown(context, "glImportMemoryFdEXT");
  imagesEscape();
  context.host->ImportMemoryFdEXT(memory, size, handleType, fd);
}

void DeleteTextures(Context &context, GLsizei n, const GLuint *textures) {
  if (context.feedback.levels() != 0 && textures && n > 0)
    for (GLsizei i = 0; i < n; ++i)
      context.feedback.forget(textures[i]);
  if (context.softwarePossible && !context.insideBeginEnd)
    context.software->residency.texturesDeleted(n, textures);
  if (context.group && !context.insideBeginEnd) {
    context.group->deletedNames.add(DeletedNames::Kind::Texture, n, textures, context.serial);
    context.group->textureViews.remove(n, textures);
  }
  context.host->DeleteTextures(n, textures);
}

void DeleteRenderbuffers(Context &context, GLsizei n, const GLuint *renderbuffers) {
  if (context.softwareListens)
    software::hostDoesUnknown(context, "glDeleteRenderbuffers");
  if (context.group && !context.insideBeginEnd)
    context.group->deletedNames.add(DeletedNames::Kind::Renderbuffer, n, renderbuffers,
                                    context.serial);
  context.host->DeleteRenderbuffers(n, renderbuffers);
}

} // namespace arbiter::state::handlers
