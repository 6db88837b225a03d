#pragma once
#include <cstddef>
#include <cstdint>

#include "swrast/setup/shape.h"

/// Draws few shapes: threads shade them in bands of rows.
namespace arbiter::swrast {

/// Shades the shapes in order. Returns the number of pixels.
std::uint64_t shadeInBands(const RasterState &state, const Shading &shading, const Shape *shapes,
                           std::size_t count);

} // namespace arbiter::swrast
