#pragma once
#include <vector>

#include "swrast/setup/draw.h"
#include "swrast/setup/place.h"

/// The vertices of a draw to window coordinates.
namespace arbiter::swrast {

/// How many of the `count` vertices are drawn, by `indices` or (null) from `first` on: 0 where
/// nothing is.
[[nodiscard]] std::uint32_t drawnCount(const RasterState &state, const Shading &shading,
                                       const Vertices &vertices, const std::uint32_t *indices,
                                       std::uint32_t first, std::uint32_t count);
/// The arguments refer to what outlives the draw. Nothing is placed yet.
[[nodiscard]] Draw drawOf(const RasterState &state, const Shading &shading, Topology topology,
                          const Vertices &vertices, const std::uint32_t *indices,
                          std::uint32_t first, std::uint32_t count);
/// Window positions of the vertices that are used, and what can be seen of their primitives.
/// \param window, bounds kept by the caller, so that a draw like the last one allocates nothing
void placeVertices(Draw &draw, std::vector<WindowVertex> &window,
                   std::vector<PlacedBounds> &bounds);

} // namespace arbiter::swrast
