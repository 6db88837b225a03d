#pragma once
#include <GL/gl.h>

#include "swrast/bits.h"

/// Bitmap (OpenGL 2.1, 3.7): fragments at the current raster position, which then moves.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

/// A bitmap's bits, and where they go from the raster position.
struct PlacedBits {
  swrast::BitImage image;
  GLfloat xOrigin = 0, yOrigin = 0;
};

/// The arguments of Bitmap.
struct BitmapCommand {
  GLsizei width = 0, height = 0;
  GLfloat xOrigin = 0, yOrigin = 0, xMove = 0, yMove = 0;
  const GLubyte *bits = nullptr; ///< an offset where a buffer is bound to PIXEL_UNPACK_BUFFER
};

/// True: carried out. False: the host's, which is brought up to date where it may draw; it raises
/// what is wrong with the arguments.
[[nodiscard]] bool tryBitmap(Context &context, const BitmapCommand &command);

} // namespace arbiter::state::software
