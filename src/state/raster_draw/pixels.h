#pragma once
#include "state/imaging/pixels.h"

/// Draws pixel rectangles of colours (OpenGL 2.1, 3.6.4): fragments with the current raster
/// position's values and a colour of their own.
namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

/// True if fragments at the raster position read more than its colour and the rasterizer can shade
/// them now. Hosts draw pixels without the other values.
[[nodiscard]] bool shadesRasterValues(RasterContext &context);
/// Draws the image of a DrawPixels and returns true. Returns false if the host must, after bringing
/// it up to date.
[[nodiscard]] bool tryPixels(RasterContext &context, const imaging::Pixels &pixels);

} // namespace arbiter::state
