#pragma once
#include "swrast/bits.h"

/// Rasterizes pixel rectangles: each fragment has its own colour, as for glDrawPixels and
/// glCopyPixels (OpenGL 2.1, 3.6.4). Knows no GL.
namespace arbiter::swrast {

/// A rectangle of colours, lowest row first, with its place in the window.
struct PixelImage {
  const float (*colors)[4] = nullptr;
  std::int32_t width = 0, height = 0;
  std::int32_t x = 0, y = 0;  ///< window coordinates of the corner of colour (0, 0)
  float zoomX = 1, zoomY = 1; ///< width and height of one colour in window pixels
};

/// Draws the image's fragments that lie within the clip rectangle. A fragment has the attributes of
/// `fragments`, but its colour becomes input `colorInput` (below 0: no input). A fragment takes the
/// colour whose rectangle contains its centre; the lower and the left edge count as inside.
/// Requires that no input is Perspective. Returns when all pixels are written.
DrawStatistics rasterizePixels(const RasterState &state, const Shading &shading,
                               const PixelImage &image, const BitFragments &fragments,
                               int colorInput);

} // namespace arbiter::swrast
