#pragma once
#include "state/core/context.h"
#include "state/objects/display_list.h"

/// Feedback below the entry points: a copy from the read buffer to a texture, called or replayed
/// from a display list.
namespace arbiter::state {

/// One of the copies, whatever its entry point.
struct CopyCommand {
  CopyKind kind = CopyKind::Image2D;
  GLenum target = 0;
  GLint level = 0;
  GLenum internalFormat = 0; ///< of a CopyTexImage
  GLint border = 0;
  CopyRegion region;
};

/// Counts the copy, and makes it between shadows, or has the host make it.
void copyTexture(Context &context, const CopyCommand &copy);
/// The same as a command of a display list, and back.
[[nodiscard]] Command commandOf(const CopyCommand &copy);
[[nodiscard]] CopyCommand copyOf(const Command &command);

/// Counts a copy from the current read buffer to `to`. Outside Begin/End; asks the host where the
/// copy comes from.
void trackCopy(Context &context, const TextureLevel &to, CopyKind kind, const CopyRegion &region);

} // namespace arbiter::state
