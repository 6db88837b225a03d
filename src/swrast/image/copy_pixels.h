#pragma once
#include "swrast/image/image.h"
#include "swrast/rect.h"

/// Copies from image to image, and fills.
namespace arbiter::swrast {

/// Copies pixels, converting where formats differ (colour to colour; each component by value).
/// Rectangles are clipped by neither side: the caller has. Source and destination may share storage
/// only if they are the same pixels or do not overlap.
void copyPixels(Image &to, int toX, int toY, int toZ, const Image &from, const Rect &rect,
                int fromZ = 0);
/// Every pixel of `rect` becomes `rgba`, components outside `writeMask` kept. Float targets are not
/// clamped.
void fill(Image &image, const Rect &rect, const float rgba[4], unsigned writeMask = 0xF);
/// The same of a depth or depth-stencil image; false flags leave a part as it is. A whole image
/// gets what the double is in its steps, a part of one what its float would be as a fragment's
/// depth: so do hosts, which clear a part by drawing it.
void fillDepthStencil(Image &image, const Rect &rect, bool depth, double depthValue,
                      std::uint8_t stencilMask, std::uint8_t stencilValue);

} // namespace arbiter::swrast
