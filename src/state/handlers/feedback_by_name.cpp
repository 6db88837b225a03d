// Texture feedback by name or by unit (direct state access). In lists the host records these
// commands, and they are not counted when executed.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/depth_images.h"
#include "state/core/texture_binding.h"
#include "state/pixel_commands/copy_texture.h"
#include "state/programs/texture_changes.h"
#include "state/raster_draw/context_state.h"

namespace arbiter::state {

namespace {

bool counts(Context &context) {
  if (context.insideBeginEnd || context.listMode != 0)
    return false;
  // The host copies: by name or unit the command may reach textures that residency does not follow.
  if (context.softwarePossible)
    context.software->residency.hostDoesAnything("glCopyTexture");
  return true;
}

void byTexture(Context &context, GLuint texture, GLenum target, GLint level, CopyKind kind,
               const CopyRegion &region) {
  if (counts(context))
    trackCopy(context, {texture, target, level}, kind, region);
}

/// Tracks a copy of ARB_direct_state_access, which names no target: the texture has its own.
void byTexture(Context &context, GLuint texture, GLint level, CopyKind kind,
               const CopyRegion &region) {
  if (!counts(context))
    return;
  GLint target = 0;
  context.host->GetTextureParameteriv(texture, GL_TEXTURE_TARGET, &target);
  trackCopy(context, {texture, GLenum(target), level}, kind, region);
}

void byUnit(Context &context, GLenum unit, GLenum target, GLint level, CopyKind kind,
            const CopyRegion &region) {
  const GLenum binding = bindingOf(target);
  if (!counts(context) || binding == 0)
    return;
  GLint active = GL_TEXTURE0, texture = 0;
  context.host->GetIntegerv(GL_ACTIVE_TEXTURE, &active);
  context.host->ActiveTexture(unit);
  context.host->GetIntegerv(binding, &texture);
  context.host->ActiveTexture(GLenum(active));
  trackCopy(context, {GLuint(texture), target, level}, kind, region);
}

} // namespace

namespace handlers {

void CopyTextureSubImage1D(Context &context, GLuint texture, GLint level, GLint xoffset, GLint x,
                           GLint y, GLsizei width) {
  byTexture(context, texture, level, CopyKind::SubImage1D, {xoffset, 0, 0, x, y, width, 1});
  context.host->CopyTextureSubImage1D(texture, level, xoffset, x, y, width);
}
void CopyTextureSubImage2D(Context &context, GLuint texture, GLint level, GLint xoffset,
                           GLint yoffset, GLint x, GLint y, GLsizei width, GLsizei height) {
  byTexture(context, texture, level, CopyKind::SubImage2D,
            {xoffset, yoffset, 0, x, y, width, height});
  context.host->CopyTextureSubImage2D(texture, level, xoffset, yoffset, x, y, width, height);
}
void CopyTextureSubImage3D(Context &context, GLuint texture, GLint level, GLint xoffset,
                           GLint yoffset, GLint zoffset, GLint x, GLint y, GLsizei width,
                           GLsizei height) {
  byTexture(context, texture, level, CopyKind::SubImage3D,
            {xoffset, yoffset, zoffset, x, y, width, height});
  context.host->CopyTextureSubImage3D(texture, level, xoffset, yoffset, zoffset, x, y, width,
                                      height);
}

// EXT_direct_state_access: one body per shape, by texture and by unit.
#define COPY_IMAGE_1D(name, by, Object)                                                            \
  void name(Context &context, Object object, GLenum target, GLint level, GLenum format, GLint x,   \
            GLint y, GLsizei width, GLint border) {                                                \
    noteInternalFormat(context, format);                                                           \
    by(context, object, target, level, CopyKind::Image1D, {0, 0, 0, x, y, width, 1});              \
    context.host->name(object, target, level, format, x, y, width, border);                        \
    noteTextureChange(context);                                                                    \
  }
#define COPY_IMAGE_2D(name, by, Object)                                                            \
  void name(Context &context, Object object, GLenum target, GLint level, GLenum format, GLint x,   \
            GLint y, GLsizei width, GLsizei height, GLint border) {                                \
    noteInternalFormat(context, format);                                                           \
    by(context, object, target, level, CopyKind::Image2D, {0, 0, 0, x, y, width, height});         \
    context.host->name(object, target, level, format, x, y, width, height, border);                \
    noteTextureChange(context);                                                                    \
  }
#define COPY_SUB_IMAGE_1D(name, by, Object)                                                        \
  void name(Context &context, Object object, GLenum target, GLint level, GLint xoffset, GLint x,   \
            GLint y, GLsizei width) {                                                              \
    by(context, object, target, level, CopyKind::SubImage1D, {xoffset, 0, 0, x, y, width, 1});     \
    context.host->name(object, target, level, xoffset, x, y, width);                               \
  }
#define COPY_SUB_IMAGE_2D(name, by, Object)                                                        \
  void name(Context &context, Object object, GLenum target, GLint level, GLint xoffset,            \
            GLint yoffset, GLint x, GLint y, GLsizei width, GLsizei height) {                      \
    by(context, object, target, level, CopyKind::SubImage2D,                                       \
       {xoffset, yoffset, 0, x, y, width, height});                                                \
    context.host->name(object, target, level, xoffset, yoffset, x, y, width, height);              \
  }
#define COPY_SUB_IMAGE_3D(name, by, Object)                                                        \
  void name(Context &context, Object object, GLenum target, GLint level, GLint xoffset,            \
            GLint yoffset, GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height) {       \
    by(context, object, target, level, CopyKind::SubImage3D,                                       \
       {xoffset, yoffset, zoffset, x, y, width, height});                                          \
    context.host->name(object, target, level, xoffset, yoffset, zoffset, x, y, width, height);     \
  }
COPY_IMAGE_1D(CopyTextureImage1DEXT, byTexture, GLuint)
COPY_IMAGE_1D(CopyMultiTexImage1DEXT, byUnit, GLenum)
COPY_IMAGE_2D(CopyTextureImage2DEXT, byTexture, GLuint)
COPY_IMAGE_2D(CopyMultiTexImage2DEXT, byUnit, GLenum)
COPY_SUB_IMAGE_1D(CopyTextureSubImage1DEXT, byTexture, GLuint)
COPY_SUB_IMAGE_1D(CopyMultiTexSubImage1DEXT, byUnit, GLenum)
COPY_SUB_IMAGE_2D(CopyTextureSubImage2DEXT, byTexture, GLuint)
COPY_SUB_IMAGE_2D(CopyMultiTexSubImage2DEXT, byUnit, GLenum)
COPY_SUB_IMAGE_3D(CopyTextureSubImage3DEXT, byTexture, GLuint)
COPY_SUB_IMAGE_3D(CopyMultiTexSubImage3DEXT, byUnit, GLenum)

} // namespace handlers
} // namespace arbiter::state
