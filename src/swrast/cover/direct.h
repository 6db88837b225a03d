#pragma once
#include <cstddef>
#include <cstdint>

#include "swrast/setup/shape.h"

/// Few shapes at a time: the rows that they cover are dealt out to the threads in bands.
namespace arbiter::swrast {

/// Shades the shapes in order; returns the pixels.
std::uint64_t shadeInBands(const RasterState &state, const Shading &shading, const Shape *shapes,
                           std::size_t count);

} // namespace arbiter::swrast
