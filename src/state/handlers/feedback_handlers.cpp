// Texture feedback: tracks, counts and executes CopyTexImage and CopyTexSubImage.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/lists/list_compiler.h"
#include "state/pixel_commands/copy_texture.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Executes the copy, or records it in a list, to be counted when it is executed. In lists before
/// the group's first program the host records it.
void performOrRecord(Context &context, const CopyCommand &copy) {
  if (context.listMode == 0 || context.insideBeginEnd ||
      !context.group->programApiUsed.load(std::memory_order_relaxed))
    return copyTexture(context, copy);
  listCompiler(context).record(context, commandOf(copy));
}

} // namespace

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
  ++context.counters.readBufferCalls;
  context.host->ReadBuffer(src);
}

} // namespace handlers
} // namespace arbiter::state
