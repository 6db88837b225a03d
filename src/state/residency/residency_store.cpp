// Follows the application's pixel store, for draws that read its memory.
#include "state/residency/residency_host.h"

namespace arbiter::state {

BitUnpacking Residency::bitUnpacking() {
  const PixelModes::Store &unpack = pixelModes(*m_images).unpack;
  return {unpack.rowLength, unpack.skipRows,      unpack.skipPixels,
          unpack.alignment, unpack.lsbFirst != 0, GLuint(unpack.buffer)};
}

bool Residency::pixelStored(GLenum pname, GLint value) {
  ResidentImages &images = *m_images;
  if ((images.hot.dirty & dirty::kPixelStore) != 0)
    return true; // all of it is queried later in any case
  PixelModes::Store &unpack = images.modes.unpack;
  GLint *field = nullptr;
  switch (pname) {
  // These are what text sets for every glyph. Other names, and values that are errors, make the
  // host be queried.
  case GL_UNPACK_SWAP_BYTES:
    unpack.swapBytes = value != 0;
    return true;
  case GL_UNPACK_LSB_FIRST:
    unpack.lsbFirst = value != 0;
    return true;
  case GL_UNPACK_ROW_LENGTH:
    field = &unpack.rowLength;
    break;
  case GL_UNPACK_SKIP_ROWS:
    field = &unpack.skipRows;
    break;
  case GL_UNPACK_SKIP_PIXELS:
    field = &unpack.skipPixels;
    break;
  case GL_UNPACK_ALIGNMENT:
    if (value != 1 && value != 2 && value != 4 && value != 8)
      return false;
    field = &unpack.alignment;
    break;
  default:
    return false;
  }
  if (value < 0)
    return false;
  *field = value;
  return true;
}

} // namespace arbiter::state
