#pragma once
#include "swrast/bits.h"

/// Pixels that are fragments of a colour each: DrawPixels and CopyPixels (OpenGL 2.1, 3.6.4),
/// without GL.
namespace arbiter::swrast {

/// A rectangle of colours, the lowest row first, and where it is drawn.
struct PixelImage {
  const float (*colors)[4] = nullptr;
  std::int32_t width = 0, height = 0;
  std::int32_t x = 0, y = 0;  ///< window coordinates of the corner of colour (0, 0)
  float zoomX = 1, zoomY = 1; ///< how wide and how high a colour is drawn, in pixels
};

/// Draws the fragments within the clip rectangle. Each is that of `fragments` but for its colour,
/// which is the value of input `colorInput`; none is where that is below 0. A fragment belongs to
/// the colour whose rectangle has its centre inside, or on the lower or the left edge. Requires:
/// no input is Perspective. Returns when all pixels are written.
DrawStatistics rasterizePixels(const RasterState &state, const Shading &shading,
                               const PixelImage &image, const BitFragments &fragments,
                               int colorInput);

} // namespace arbiter::swrast
