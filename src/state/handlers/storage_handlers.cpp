// Commands that make objects share storage or use the application's memory, and commands that
// delete such objects. Other contexts of the group must know of them, so they come here in
// passed-through contexts too (`everywhere` in entry_points.toml), and without any context.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/programs/texture_changes.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/neighbours.h"
#include "state/raster_draw/vertices/buffer_copies.h"
#include "state/share/share_group.h"

namespace arbiter::state::handlers {

namespace {

/// True if a command's renderbuffer can be queried: there is a rasterizer, and no list is being
/// compiled.
bool knowsWhich(const Context &context) { return context.software && context.executesNow(); }

void renderbufferRedefined(Context &context, const char *name) {
  if (knowsWhich(context))
    context.software->residency.renderbufferRedefined();
  else if (context.softwareListens)
    hostDoesUnknown(context, name);
}

} // namespace

void TextureView(Context &context, GLuint texture, GLenum target, GLuint origtexture,
                 GLenum internalformat, GLuint minlevel, GLuint numlevels, GLuint minlayer,
                 GLuint numlayers) {
  if (context.softwareListens)
    hostDoesUnknown(context, "glTextureView");
  if (context.group)
    context.group->textureViews.add(texture, origtexture);
  context.host->TextureView(texture, target, origtexture, internalformat, minlevel, numlevels,
                            minlayer, numlayers);
}

/// Textures and buffers in imported memory change with each other, and by the process that exported
/// it.
void ImportMemoryFdEXT(Context &context, GLuint memory, GLuint64 size, GLenum handleType,
                       GLint fd) {
  if (context.softwareListens)
    hostDoesUnknown(context, "glImportMemoryFdEXT");
  imagesEscape();
  context.host->ImportMemoryFdEXT(memory, size, handleType, fd);
}

void DeleteTextures(Context &context, GLsizei n, const GLuint *textures) {
  if (context.counters.feedback.levels() != 0 && textures && n > 0)
    for (GLsizei i = 0; i < n; ++i)
      context.counters.feedback.forget(textures[i]);
  if (context.softwarePossible && !context.insideBeginEnd)
    context.software->residency.texturesDeleted(n, textures);
  if (context.group && !context.insideBeginEnd) {
    context.group->deletedNames.add(DeletedNames::Kind::Texture, n, textures, context.serial);
    context.group->textureViews.remove(n, textures);
    context.group->textureFormats.remove(n, textures);
    context.group->textureRanges.remove(n, textures);
  }
  context.host->DeleteTextures(n, textures);
  noteTextureChange(context);
}

void DeleteRenderbuffers(Context &context, GLsizei n, const GLuint *renderbuffers) {
  if (knowsWhich(context))
    context.software->residency.renderbuffersDeleted(n, renderbuffers);
  else if (context.softwareListens)
    hostDoesUnknown(context, "glDeleteRenderbuffers");
  if (context.group && !context.insideBeginEnd)
    context.group->deletedNames.add(DeletedNames::Kind::Renderbuffer, n, renderbuffers,
                                    context.serial);
  context.host->DeleteRenderbuffers(n, renderbuffers);
}

void RenderbufferStorage(Context &context, GLenum target, GLenum internalformat, GLsizei width,
                         GLsizei height) {
  renderbufferRedefined(context, "glRenderbufferStorage");
  context.host->RenderbufferStorage(target, internalformat, width, height);
}

void RenderbufferStorageMultisample(Context &context, GLenum target, GLsizei samples,
                                    GLenum internalformat, GLsizei width, GLsizei height) {
  renderbufferRedefined(context, "glRenderbufferStorageMultisample");
  context.host->RenderbufferStorageMultisample(target, samples, internalformat, width, height);
}

void BufferData(Context &context, GLenum target, GLsizeiptr size, const void *data, GLenum usage) {
  if (target == GL_EXTERNAL_VIRTUAL_MEMORY_BUFFER_AMD) [[unlikely]]
    BufferCopies::stop();
  context.host->BufferData(target, size, data, usage);
}

} // namespace arbiter::state::handlers
