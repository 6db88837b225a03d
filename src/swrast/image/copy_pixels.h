#pragma once
#include "swrast/image/image.h"
#include "swrast/rect.h"

/// Copies pixels between images, and fills them.
namespace arbiter::swrast {

/// Copies pixels. Where formats differ they are converted, colours to colours only, component by
/// component. Rectangles are not clipped, so the caller must do that. The source and the
/// destination may share storage only if they are the same pixels or do not overlap.
void copyPixels(Image &to, int toX, int toY, int toZ, const Image &from, const Rect &rect,
                int fromZ = 0);
/// Sets every pixel of `rect` to `rgba`, and keeps the components outside `writeMask`. Float
/// targets are not clamped.
void fill(Image &image, const Rect &rect, const float rgba[4], unsigned writeMask = 0xF);
/// Sets depth, stencil or both of every pixel of `rect`. If `depth` is false depths are kept, and
/// stencil bits outside `stencilMask` are kept. A whole image gets the double converted to the
/// format's steps; a part gets the value of a fragment with that depth as a float. Hosts differ in
/// the same way, because they clear a part by drawing it.
void fillDepthStencil(Image &image, const Rect &rect, bool depth, double depthValue,
                      std::uint8_t stencilMask, std::uint8_t stencilValue);

} // namespace arbiter::swrast
