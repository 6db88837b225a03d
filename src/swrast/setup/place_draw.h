#pragma once
#include <vector>

#include "swrast/setup/draw.h"
#include "swrast/setup/place.h"

/// Prepares a draw: transforms its vertices to window coordinates.
namespace arbiter::swrast {

/// Returns how many of the `count` vertices to draw, or 0 if nothing can be drawn. They are those
/// that `indices` names, or, if it is null, those from `first` on.
[[nodiscard]] std::uint32_t drawnCount(const DrawArguments &draw);
/// Makes a Draw without vertex positions. Its arguments must outlive the draw.
[[nodiscard]] Draw drawOf(const DrawArguments &arguments);
/// Computes the window positions of the used vertices, and the pixels that their primitives may
/// reach.
/// \param window, bounds buffers that the caller keeps, so that repeated draws allocate nothing
void placeVertices(Draw &draw, std::vector<WindowVertex> &window,
                   std::vector<PlacedBounds> &bounds);

} // namespace arbiter::swrast
