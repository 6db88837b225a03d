// Texture feedback: CopyTexImage and CopyTexSubImage are tracked, counted and passed on.
#include <cstring>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/core/share_group.h"
#include "state/core/texture_binding.h"
#include "state/handlers/feedback.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_api.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"

namespace arbiter::state {

namespace {

/// One of the copies, whatever its entry point.
struct CopyCommand {
  CopyKind kind = CopyKind::Image2D;
  GLenum target = 0;
  GLint level = 0;
  GLenum internalFormat = 0; ///< of a CopyTexImage
  GLint border = 0;
  CopyRegion region;
};

void forward(const host::HostTable &host, const CopyCommand &c) {
  const CopyRegion &r = c.region;
  switch (c.kind) {
  case CopyKind::Image1D:
    return host.CopyTexImage1D(c.target, c.level, c.internalFormat, r.x, r.y, r.width, c.border);
  case CopyKind::Image2D:
    return host.CopyTexImage2D(c.target, c.level, c.internalFormat, r.x, r.y, r.width, r.height,
                               c.border);
  case CopyKind::SubImage1D:
    return host.CopyTexSubImage1D(c.target, c.level, r.destX, r.x, r.y, r.width);
  case CopyKind::SubImage2D:
    return host.CopyTexSubImage2D(c.target, c.level, r.destX, r.destY, r.x, r.y, r.width, r.height);
  case CopyKind::SubImage3D:
    return host.CopyTexSubImage3D(c.target, c.level, r.destX, r.destY, r.destZ, r.x, r.y, r.width,
                                  r.height);
  }
}

/// The copy is made between shadows; else the host, which is told what it lacks, makes it.
bool copiedByUs(Context &context, const CopyCommand &copy) {
  const bool defines = copy.kind == CopyKind::Image1D || copy.kind == CopyKind::Image2D;
  const CopyRegion &r = copy.region;
  if (!context.software)
    return false;
  software::Residency &residency = context.software->residency;
  if (residency.copyToTexture({copy.target, copy.level, defines, copy.internalFormat, copy.border,
                               r.destX, r.destY, r.destZ, r.x, r.y, r.width, r.height}))
    return true;
  residency.synchronise("glCopyTexImage");
  residency.textureRedefined(copy.target);
  return false;
}

/// Where the copy goes to is asked from the host: bindings are passed on untracked, and a query is
/// small beside a copy.
void perform(Context &context, const CopyCommand &copy) {
  const GLenum binding = bindingOf(copy.target);
  if (!context.insideBeginEnd && context.listMode != GL_COMPILE && binding != 0) {
    GLint texture = 0;
    context.host->GetIntegerv(binding, &texture);
    trackCopy(context, {GLuint(texture), copy.target, copy.level}, copy.kind, copy.region);
  }
  if (context.softwarePossible && !context.insideBeginEnd && context.listMode == 0 &&
      copiedByUs(context, copy))
    return;
  forward(*context.host, copy);
}

/// In a list the copy is a command of ours, to be counted when it is executed; in one that is older
/// than the group's first program it is the host's.
void performOrRecord(Context &context, const CopyCommand &copy) {
  if (context.listMode == 0 || context.insideBeginEnd ||
      !context.group->programApiUsed.load(std::memory_order_relaxed))
    return perform(context, copy);
  Command command{.kind = Command::Kind::CopyTexture, .target = copy.target};
  command.object = GLuint(copy.kind);
  command.format = copy.internalFormat;
  command.count = copy.level;
  command.name = GLuint(copy.border);
  command.bytes.assign(reinterpret_cast<const char *>(&copy.region), sizeof copy.region);
  context.list->record(context, std::move(command));
}

} // namespace

void trackCopy(Context &context, const TextureLevel &to, CopyKind kind, const CopyRegion &region) {
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    context.host->GetIntegerv(pname, &value);
    return GLuint(value);
  };
  ColorBuffer source;
  if (context.caps.framebufferObjects)
    source.framebuffer = get(GL_READ_FRAMEBUFFER_BINDING);
  source.buffer = get(GL_READ_BUFFER);
  context.feedback.record(to, kind, source, region, context.frames);
}

void copyTexture(Context &context, const Command &command) {
  CopyCommand copy{.kind = CopyKind(command.object), .target = command.target};
  copy.level = command.count;
  copy.internalFormat = command.format;
  copy.border = GLint(command.name);
  std::memcpy(&copy.region, command.bytes.data(), sizeof copy.region);
  perform(context, copy);
}

namespace handlers {

void CopyTexImage1D(Context &context, GLenum target, GLint level, GLenum internalformat, GLint x,
                    GLint y, GLsizei width, GLint border) {
  performOrRecord(context, {CopyKind::Image1D,
                            target,
                            level,
                            internalformat,
                            border,
                            {.x = x, .y = y, .width = width, .height = 1}});
}

void CopyTexImage2D(Context &context, GLenum target, GLint level, GLenum internalformat, GLint x,
                    GLint y, GLsizei width, GLsizei height, GLint border) {
  performOrRecord(context, {CopyKind::Image2D,
                            target,
                            level,
                            internalformat,
                            border,
                            {.x = x, .y = y, .width = width, .height = height}});
}

void CopyTexSubImage1D(Context &context, GLenum target, GLint level, GLint xoffset, GLint x,
                       GLint y, GLsizei width) {
  performOrRecord(context, {CopyKind::SubImage1D,
                            target,
                            level,
                            0,
                            0,
                            {.destX = xoffset, .x = x, .y = y, .width = width, .height = 1}});
}

void CopyTexSubImage2D(Context &context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                       GLint x, GLint y, GLsizei width, GLsizei height) {
  performOrRecord(
      context,
      {CopyKind::SubImage2D, target, level, 0, 0, {xoffset, yoffset, 0, x, y, width, height}});
}

void CopyTexSubImage3D(Context &context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                       GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height) {
  performOrRecord(context, {CopyKind::SubImage3D,
                            target,
                            level,
                            0,
                            0,
                            {xoffset, yoffset, zoffset, x, y, width, height}});
}

void ReadBuffer(Context &context, GLenum src) {
  ++context.readBufferCalls;
  context.host->ReadBuffer(src);
}

void DeleteTextures(Context &context, GLsizei n, const GLuint *textures) {
  if (context.feedback.levels() != 0 && textures && n > 0)
    for (GLsizei i = 0; i < n; ++i)
      context.feedback.forget(textures[i]);
  if (context.softwarePossible && !context.insideBeginEnd)
    context.software->residency.texturesDeleted(n, textures);
  if (!context.insideBeginEnd)
    context.group->deletedNames.add(DeletedNames::Kind::Texture, n, textures, context.serial);
  context.host->DeleteTextures(n, textures);
}

void DeleteRenderbuffers(Context &context, GLsizei n, const GLuint *renderbuffers) {
  if (context.softwareListens)
    software::hostDoesUnknown(context, "glDeleteRenderbuffers");
  if (!context.insideBeginEnd)
    context.group->deletedNames.add(DeletedNames::Kind::Renderbuffer, n, renderbuffers,
                                    context.serial);
  context.host->DeleteRenderbuffers(n, renderbuffers);
}

} // namespace handlers
} // namespace arbiter::state
