#pragma once
#include "state/imaging/pixels.h"

/// Pixel rectangles of colours (OpenGL 2.1, 3.6.4): fragments that have the current raster
/// position's values beside a colour of their own.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

/// True if fragments at the raster position are shaded with more than their colour, and the
/// rasterizer can shade them now: hosts draw pixels without the rest of its values.
[[nodiscard]] bool shadesRasterValues(Context &context);
/// Draws what DrawPixels has made of its image. True: drawn. False: the host's, which is brought up
/// to date.
[[nodiscard]] bool tryPixels(Context &context, const imaging::Pixels &pixels);

} // namespace arbiter::state::software
