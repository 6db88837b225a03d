#pragma once
#include <GL/gl.h>

#include "swrast/bits.h"

/// Draws glBitmap (OpenGL 2.1, 3.7): fragments at the current raster position, which then moves.
namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

/// A bitmap, with its offset from the raster position.
struct PlacedBits {
  swrast::BitImage image;
  GLfloat xOrigin = 0, yOrigin = 0;
};

/// The arguments of glBitmap.
struct BitmapCommand {
  GLsizei width = 0, height = 0;
  GLfloat xOrigin = 0, yOrigin = 0, xMove = 0, yMove = 0;
  const GLubyte *bits = nullptr; ///< an offset if a buffer is bound to PIXEL_UNPACK_BUFFER
};

/// Executes glBitmap and returns true. Returns false if the host must do it, after bringing the
/// host up to date where it may draw. The host also reports invalid arguments.
[[nodiscard]] bool tryBitmap(RasterContext &context, const BitmapCommand &command);

} // namespace arbiter::state
