#pragma once
#include <cstdint>

#include "swrast/draw_input.h"

/// Primitives to fragments: assembly, clipping, culling, setup, tiles. Knows no GL; shading is a
/// function of machine code that it is given.
namespace arbiter::swrast {

/// Draws `count` vertices, by `indices` or (null) from `first` on. An index beyond the vertices is
/// not drawn. Returns when all pixels are written. \param provokingAt Draw::provokingAt
DrawStatistics rasterize(const RasterState &state, const Shading &shading, Topology topology,
                         const Vertices &vertices, const std::uint32_t *indices,
                         std::uint32_t first, std::uint32_t count, std::uint32_t provokingAt = 0);

} // namespace arbiter::swrast
