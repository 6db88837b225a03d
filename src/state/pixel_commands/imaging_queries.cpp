#include "state/pixel_commands/imaging_queries.h"

#include "state/core/errors.h"
#include "state/imaging/formats.h"
#include "state/pixel_commands/transfer.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

bool returnImage(RasterContext &context, GLenum internalFormat, const imaging::Pixels &image,
                 GLenum format, GLenum type, void *to) {
  if (!isColorFormat(format) || format == GL_COLOR_INDEX) {
    raise(context, GL_INVALID_ENUM, "a query of imaging: format");
    return false;
  }
  imaging::Pixels pixels = image;
  for (imaging::Rgba &texel : pixels.texels)
    texel = returned(imaging::baseOf(internalFormat), texel);
  if (format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA) // luminance is red's
    for (imaging::Rgba &texel : pixels.texels)
      texel[1] = texel[2] = 0;
  return packPixels(context, pixels, format, type, to);
}

} // namespace arbiter::state
