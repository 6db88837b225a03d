#include "state/pixel_commands/copy_texture.h"

#include <cstring>

#include "host/host_table.h"
#include "state/core/depth_images.h"
#include "state/core/errors.h"
#include "state/core/texture_binding.h"
#include "state/pixel_commands/pixel_commands.h"
#include "state/programs/texture_changes.h"
#include "state/programs/texture_shaders/component_formats.h"
#include "state/programs/texture_shaders/component_image.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/raster_draw/context_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

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

/// Converts the command for residency.
CopyToTexture copyTo(GLuint texture, const CopyCommand &copy) {
  const bool defines = copy.kind == CopyKind::Image1D || copy.kind == CopyKind::Image2D;
  const CopyRegion &r = copy.region;
  return {texture,     copy.target, copy.level, defines, copy.internalFormat,
          copy.border, r.destX,     r.destY,    r.destZ, r.x,
          r.y,         r.width,     r.height};
}

} // namespace

void trackCopy(RasterContext &context, const TextureLevel &to, CopyKind kind,
               const CopyRegion &region) {
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    context.host->GetIntegerv(pname, &value);
    return GLuint(value);
  };
  ColorBuffer source;
  if (context.caps.framebufferObjects)
    source.framebuffer = get(GL_READ_FRAMEBUFFER_BINDING);
  source.buffer = get(GL_READ_BUFFER);
  context.counters.feedback.record(to, kind, source, region, context.counters.frames);
}

namespace {

/// Copies to an image whose format the host has. The destination is queried from the host, because
/// bindings are passed on untracked, and a query is cheap beside a copy.
void copyColors(RasterContext &context, const CopyCommand &copy) {
  if (context.insideBeginEnd || context.listMode == GL_COMPILE)
    return forward(*context.host, copy);
  GLint texture = 0;
  if (const GLenum binding = bindingOf(copy.target)) {
    context.host->GetIntegerv(binding, &texture);
    trackCopy(context, {GLuint(texture), copy.target, copy.level}, copy.kind, copy.region);
  }
  if (context.imagesPixels && context.listMode == 0 && imagedCopyTexture(context, copy))
      [[unlikely]]
    return;
  if (context.software && context.listMode == 0 &&
      context.software->residency.copyToTexture(copyTo(GLuint(texture), copy)))
    return;
  forward(*context.host, copy);
}

bool defines(CopyKind kind) { return kind == CopyKind::Image1D || kind == CopyKind::Image2D; }

/// True if the image has HILO components or belongs to a texture offset group (NV_texture_shader,
/// 3.8.2), which cannot be copied to.
bool takesNoColors(RasterContext &context, const CopyCommand &copy) {
  const GLenum name = defines(copy.kind) ? copy.internalFormat
                                         : componentFormatOf(context, copy.target, copy.level);
  const ComponentFormat *const format = componentFormat(name);
  return format && format->external != 0;
}

/// Copies to an image if internal formats may be those of NV_texture_shader.
void copyToOwnFormat(RasterContext &context, const CopyCommand &copy) {
  if (takesNoColors(context, copy))
    return raise(context, GL_INVALID_OPERATION, "CopyTexImage: the image has no colours");
  const ComponentFormat *const own =
      defines(copy.kind)
          ? componentFormat(copy.internalFormat, context.textureShaders->extensions())
          : nullptr;
  CopyCommand hosts = copy;
  if (own)
    hosts.internalFormat = hostFormat(*own, context.caps);
  if (!defines(copy.kind) || (!own && !context.group->textureFormats.any()))
    return copyColors(context, hosts);
  const GLenum earlier = takeHostErrors(*context.host);
  copyColors(context, hosts);
  const GLenum error = takeHostErrors(*context.host);
  if (error == GL_NO_ERROR)
    noteImageFormat(context, copy.target, copy.level, own ? own->name : 0);
  if (earlier != GL_NO_ERROR || error != GL_NO_ERROR)
    raise(context, earlier != GL_NO_ERROR ? earlier : error, "CopyTexImage");
}

} // namespace

void copyTexture(RasterContext &context, const CopyCommand &copy) {
  if (defines(copy.kind)) {
    noteInternalFormat(context, copy.internalFormat);
    noteTextureChange(context);
  }
  if (context.textureShaders && !context.insideBeginEnd && context.listMode != GL_COMPILE)
    return copyToOwnFormat(context, copy);
  copyColors(context, copy);
}

Command commandOf(const CopyCommand &copy) {
  Command command{.kind = Command::Kind::CopyTexture, .target = copy.target};
  command.object = GLuint(copy.kind);
  command.format = copy.internalFormat;
  command.count = copy.level;
  command.name = GLuint(copy.border);
  command.bytes.assign(reinterpret_cast<const char *>(&copy.region), sizeof copy.region);
  return command;
}

CopyCommand copyOf(const Command &command) {
  CopyCommand copy{.kind = CopyKind(command.object), .target = command.target};
  copy.level = command.count;
  copy.internalFormat = command.format;
  copy.border = GLint(command.name);
  std::memcpy(&copy.region, command.bytes.data(), sizeof copy.region);
  return copy;
}

} // namespace arbiter::state
