#include "swrast/place.h"

#include "swrast/place_block.h"

namespace arbiter::swrast {

PlacedBounds placeVerticesBaseline(const Viewport &viewport, const Vertices &vertices,
                                   std::uint32_t begin, std::uint32_t end, WindowVertex *window) {
  return placeAll(viewport, vertices, begin, end, window);
}

PlaceVertices choosePlaceVertices() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
      return placeVerticesAvx512;
    return placeVerticesAvx2;
  }
#endif
  return placeVerticesBaseline;
}

} // namespace arbiter::swrast
