#include "swrast/setup/place_block.h"

namespace arbiter::swrast {

PlacedBounds placeVerticesAvx512(const Viewport &viewport, const Vertices &vertices,
                                 std::uint32_t begin, std::uint32_t end, WindowVertex *window) {
  return placeAll(viewport, vertices, begin, end, window);
}

} // namespace arbiter::swrast
