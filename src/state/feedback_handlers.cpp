// Texture feedback: CopyTexImage and CopyTexSubImage are tracked, counted and passed on.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context.h"

namespace arbiter::state {

namespace {

using swrast::CopyKind;

GLenum bindingOf(GLenum target) {
  switch (target) {
  case GL_TEXTURE_1D:
    return GL_TEXTURE_BINDING_1D;
  case GL_TEXTURE_2D:
    return GL_TEXTURE_BINDING_2D;
  case GL_TEXTURE_3D:
    return GL_TEXTURE_BINDING_3D;
  case GL_TEXTURE_RECTANGLE:
    return GL_TEXTURE_BINDING_RECTANGLE;
  default:
    return target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z
               ? GL_TEXTURE_BINDING_CUBE_MAP
               : 0;
  }
}

GLuint getName(const Context &context, GLenum pname) {
  GLint name = 0;
  context.host->GetIntegerv(pname, &name);
  return GLuint(name);
}

/// Where the copy goes from and to is asked from the host: bindings are passed on untracked, and a
/// query is small beside a copy. Copies compiled into a list are the host's alone.
void track(Context &context, CopyKind kind, GLenum target, GLint level,
           const swrast::CopyRegion &region) {
  const GLenum binding = bindingOf(target);
  if (context.insideBeginEnd || context.listMode == GL_COMPILE || binding == 0)
    return;
  swrast::ColorBuffer source;
  if (context.caps.framebufferObjects)
    source.framebuffer = getName(context, GL_READ_FRAMEBUFFER_BINDING);
  source.buffer = getName(context, GL_READ_BUFFER);
  context.feedback.record({getName(context, binding), target, level}, kind, source, region,
                          context.frames);
}

} // namespace

namespace handlers {

void CopyTexImage1D(Context &context, GLenum target, GLint level, GLenum internalformat, GLint x,
                    GLint y, GLsizei width, GLint border) {
  track(context, CopyKind::Image1D, target, level, {.x = x, .y = y, .width = width, .height = 1});
  context.host->CopyTexImage1D(target, level, internalformat, x, y, width, border);
}

void CopyTexImage2D(Context &context, GLenum target, GLint level, GLenum internalformat, GLint x,
                    GLint y, GLsizei width, GLsizei height, GLint border) {
  track(context, CopyKind::Image2D, target, level,
        {.x = x, .y = y, .width = width, .height = height});
  context.host->CopyTexImage2D(target, level, internalformat, x, y, width, height, border);
}

void CopyTexSubImage1D(Context &context, GLenum target, GLint level, GLint xoffset, GLint x,
                       GLint y, GLsizei width) {
  track(context, CopyKind::SubImage1D, target, level,
        {.destX = xoffset, .x = x, .y = y, .width = width, .height = 1});
  context.host->CopyTexSubImage1D(target, level, xoffset, x, y, width);
}

void CopyTexSubImage2D(Context &context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                       GLint x, GLint y, GLsizei width, GLsizei height) {
  track(context, CopyKind::SubImage2D, target, level,
        {.destX = xoffset, .destY = yoffset, .x = x, .y = y, .width = width, .height = height});
  context.host->CopyTexSubImage2D(target, level, xoffset, yoffset, x, y, width, height);
}

void CopyTexSubImage3D(Context &context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                       GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height) {
  track(context, CopyKind::SubImage3D, target, level,
        {.destX = xoffset,
         .destY = yoffset,
         .destZ = zoffset,
         .x = x,
         .y = y,
         .width = width,
         .height = height});
  context.host->CopyTexSubImage3D(target, level, xoffset, yoffset, zoffset, x, y, width, height);
}

void ReadBuffer(Context &context, GLenum src) {
  ++context.readBufferCalls;
  context.host->ReadBuffer(src);
}

void DeleteTextures(Context &context, GLsizei n, const GLuint *textures) {
  if (context.feedback.levels() != 0 && textures && n > 0)
    for (GLsizei i = 0; i < n; ++i)
      context.feedback.forget(textures[i]);
  context.host->DeleteTextures(n, textures);
}

} // namespace handlers
} // namespace arbiter::state
