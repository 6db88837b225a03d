#pragma once
#include <cstdint>

#include "swrast/draw_input.h"

/// The rasterizer's entry point: assembly, clipping, culling, setup and tiles. Knows no GL. Pixels
/// are shaded by the machine code that it is given.
namespace arbiter::swrast {

/// Draws `count` vertices: those that `indices` names, or, if it is null, those from `first` on.
/// Indices beyond the last vertex are skipped. Returns when all pixels are written.
/// \param provokingAt see Draw::provokingAt
DrawStatistics rasterize(const RasterState &state, const Shading &shading, Topology topology,
                         const Vertices &vertices, const std::uint32_t *indices,
                         std::uint32_t first, std::uint32_t count, std::uint32_t provokingAt = 0);

} // namespace arbiter::swrast
