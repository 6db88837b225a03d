#include "swrast/setup/place.h"

#include "swrast/setup/place_block.h"
#include "util/processor.h"

namespace arbiter::swrast {

PlacedBounds placeVerticesBaseline(const Viewport &viewport, const Vertices &vertices,
                                   std::uint32_t begin, std::uint32_t end, WindowVertex *window) {
  return placeAll(viewport, vertices, begin, end, window);
}

void placeCorners(const Viewport &viewport, const Vertices &vertices, const std::uint32_t index[4],
                  WindowVertex window[4]) {
  Floats clip[4] = {{}, {}, {}, Floats{} + 1.0f};
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < 4; ++i)
      clip[c][i] = vertices.position[c][index[i]];
  PlacedBlock block;
  block.outcode = outcodesOf(clip, viewport.depthClamp);
  for (unsigned planes = viewport.userPlanes; planes != 0; planes &= planes - 1) {
    const auto plane = unsigned(__builtin_ctz(planes));
    for (int i = 0; i < 4; ++i)
      if (!(vertices.clipDistance[plane][index[i]] >= 0))
        block.outcode[i] |= std::int32_t(kOutUser << plane);
  }
  placeBlock(viewport, clip, block);
  store(block, 4, window);
}

PlaceVertices choosePlaceVertices() {
#if defined(__x86_64__) || defined(__i386__)
  if (vectors() == Vectors::Avx512)
    return placeVerticesAvx512;
  if (vectors() == Vectors::Avx2)
    return placeVerticesAvx2;
#endif
  return placeVerticesBaseline;
}

} // namespace arbiter::swrast
