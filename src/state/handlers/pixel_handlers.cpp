// Pixel commands that the rasterizer takes part in: they read, clear or update shadows. Called
// where the rasterizer is possible.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/depth_images.h"
#include "state/core/errors.h"
#include "state/era/era_state.h"
#include "state/lists/list_compiler.h"
#include "state/lists/texture_commands.h"
#include "state/mirror/dirty_bits.h"
#include "state/pixel_commands/pixel_commands.h"
#include "state/programs/texture_shaders/component_formats.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/frames/frame.h"

namespace arbiter::state::handlers {

void Clear(Context &context, GLbitfield mask) {
  if (executesPixels(context) && context.software) {
    clearsTarget(context, mask);
    // The host decides whether it happens (OpenGL 3.0, 2.14).
    if (!context.software->mirror.conditional && context.software->residency.clear(mask))
      return;
    context.software->residency.hostTakesTargets("glClear");
  }
  context.host->Clear(mask);
}

void BlitFramebuffer(Context &context, GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1,
                     GLint dstX0, GLint dstY0, GLint dstX1, GLint dstY1, GLbitfield mask,
                     GLenum filter) {
  if (executesPixels(context) && context.software) {
    if (!context.software->mirror.conditional &&
        context.software->residency.blit(
            {{srcX0, srcY0, srcX1, srcY1}, {dstX0, dstY0, dstX1, dstY1}, mask, filter}))
      return;
    context.software->residency.hostTakesTargets("glBlitFramebuffer");
  }
  context.host->BlitFramebuffer(srcX0, srcY0, srcX1, srcY1, dstX0, dstY0, dstX1, dstY1, mask,
                                filter);
}

void ReadPixels(Context &context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                GLenum type, void *pixels) {
  if (hasTextureShaders(context) && !context.insideBeginEnd &&
      (isComponentFormat(format) || isSignedPacked(type))) [[unlikely]]
    return raise(context, GL_INVALID_ENUM, "ReadPixels: a format or type of textures alone");
  if (context.imagesPixels && imagedReadPixels(context, x, y, width, height, format, type, pixels))
      [[unlikely]]
    return;
  if (context.executesNow() && context.software) {
    context.software->habits.readsPixels = true;
    if (context.software->residency.readPixels(x, y, width, height, format, type, pixels))
      return;
    context.software->residency.synchronise("glReadPixels");
  }
  context.host->ReadPixels(x, y, width, height, format, type, pixels);
}

void Flush(Context &context) {
  if (context.executesNow() && context.software)
    return context.software->residency.flush(false);
  context.host->Flush();
}

void Finish(Context &context) {
  if (!context.executesNow() || !context.software)
    return context.host->Finish();
  context.software->residency.flush(true);
  finishFrame(context);
}

void Viewport(Context &context, GLint x, GLint y, GLsizei width, GLsizei height) {
  if (context.executesNow() && context.software)
    context.software->residency.drawableMayHaveChanged({x, y, width, height});
  context.host->Viewport(x, y, width, height);
}

// --- The pixel store ---

namespace {

void pixelStored(Context &context, GLenum pname, GLint value) {
  if (!context.executesNow() || !context.software ||
      !context.software->residency.pixelStored(pname, value))
    context.dirty |= dirty::kPixelStore;
}

} // namespace

void PixelStorei(Context &context, GLenum pname, GLint param) {
  if (setClientStorage(context, pname, param != 0))
    return;
  context.host->PixelStorei(pname, param);
  pixelStored(context, pname, param);
}

void PixelStoref(Context &context, GLenum pname, GLfloat param) {
  if (setClientStorage(context, pname, param != 0.0f))
    return;
  context.host->PixelStoref(pname, param);
  context.dirty |= dirty::kPixelStore; // the host decides how to round
}

// --- Commands that (re)define a level ---

#define ARBITER_REDEFINES(Name, Parameters, Arguments)                                             \
  void Name Parameters {                                                                           \
    if (executesPixels(context) && context.software)                                               \
      context.software->residency.textureRedefined(target);                                        \
    context.host->Name Arguments;                                                                  \
    noteTextureCommand(context);                                                                   \
  }
#define ARBITER_STORES(Name, Parameters, Arguments)                                                \
  void Name Parameters {                                                                           \
    noteInternalFormat(context, internalformat);                                                   \
    if (executesPixels(context) && context.software)                                               \
      context.software->residency.textureRedefined(target);                                        \
    context.host->Name Arguments;                                                                  \
    noteTextureCommand(context);                                                                   \
  }

ARBITER_REDEFINES(CompressedTexImage1D,
                  (Context & context, GLenum target, GLint level, GLenum internalformat,
                   GLsizei width, GLint border, GLsizei size, const void *data),
                  (target, level, internalformat, width, border, size, data))
ARBITER_REDEFINES(CompressedTexImage2D,
                  (Context & context, GLenum target, GLint level, GLenum internalformat,
                   GLsizei width, GLsizei height, GLint border, GLsizei size, const void *data),
                  (target, level, internalformat, width, height, border, size, data))
ARBITER_REDEFINES(CompressedTexImage3D,
                  (Context & context, GLenum target, GLint level, GLenum internalformat,
                   GLsizei width, GLsizei height, GLsizei depth, GLint border, GLsizei size,
                   const void *data),
                  (target, level, internalformat, width, height, depth, border, size, data))
ARBITER_REDEFINES(CompressedTexSubImage1D,
                  (Context & context, GLenum target, GLint level, GLint x, GLsizei width,
                   GLenum format, GLsizei size, const void *data),
                  (target, level, x, width, format, size, data))
ARBITER_REDEFINES(CompressedTexSubImage2D,
                  (Context & context, GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                   GLsizei height, GLenum format, GLsizei size, const void *data),
                  (target, level, x, y, width, height, format, size, data))
ARBITER_REDEFINES(CompressedTexSubImage3D,
                  (Context & context, GLenum target, GLint level, GLint x, GLint y, GLint z,
                   GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLsizei size,
                   const void *data),
                  (target, level, x, y, z, width, height, depth, format, size, data))
ARBITER_STORES(TexStorage1D,
               (Context & context, GLenum target, GLsizei levels, GLenum internalformat,
                GLsizei width),
               (target, levels, internalformat, width))
ARBITER_STORES(TexStorage2D,
               (Context & context, GLenum target, GLsizei levels, GLenum internalformat,
                GLsizei width, GLsizei height),
               (target, levels, internalformat, width, height))
ARBITER_STORES(TexStorage3D,
               (Context & context, GLenum target, GLsizei levels, GLenum internalformat,
                GLsizei width, GLsizei height, GLsizei depth),
               (target, levels, internalformat, width, height, depth))
ARBITER_REDEFINES(GenerateMipmap, (Context & context, GLenum target), (target))
#undef ARBITER_REDEFINES
#undef ARBITER_STORES

} // namespace arbiter::state::handlers
