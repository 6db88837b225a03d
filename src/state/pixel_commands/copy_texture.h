#pragma once
#include "state/objects/display_list.h"
#include "state/raster_draw/raster_context.h"

/// Copies from the read buffer to a texture, called directly or replayed from a display list.
namespace arbiter::state {

/// One of the copy commands, whatever its entry point.
struct CopyCommand {
  CopyKind kind = CopyKind::Image2D;
  GLenum target = 0;
  GLint level = 0;
  GLenum internalFormat = 0; ///< for CopyTexImage
  GLint border = 0;
  CopyRegion region;
};

/// Counts the copy, and makes it between shadows or on the host.
void copyTexture(RasterContext &context, const CopyCommand &copy);
/// Converts between a copy and a display list's command.
[[nodiscard]] Command commandOf(const CopyCommand &copy);
[[nodiscard]] CopyCommand copyOf(const Command &command);

/// Counts a copy from the current read buffer to `to`. Queries the host for the read buffer.
/// Requires that it is called outside Begin/End.
void trackCopy(RasterContext &context, const TextureLevel &to, CopyKind kind,
               const CopyRegion &region);

} // namespace arbiter::state
