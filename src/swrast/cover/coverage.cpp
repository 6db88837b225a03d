#include "swrast/cover/coverage.h"

#include <algorithm>
#include <cstdlib>

#include "swrast/cover/coverage_block.h"
#include "util/processor.h"

namespace arbiter::swrast {

const CoverKernels kCoverBaseline = {coverSmallBlocks, coverRegionBlocks};

const CoverKernels &chooseCoverKernels() {
#if defined(__x86_64__) || defined(__i386__)
  if (vectors() == Vectors::Avx512)
    return kCoverAvx512;
  if (vectors() == Vectors::Avx2)
    return kCoverAvx2;
#endif
  return kCoverBaseline;
}

bool fitsRegions(const Shape &shape) {
  // In a tile of 64 pixels, an edge that crosses it is at most (|a| + |b|) * 63 from 0. The kernels
  // look up to a tile and a block further: 1.5 * 2^23 * 131 < 2^31.
  constexpr std::int64_t kMax = std::int64_t(3) << 22;
  return std::all_of(shape.edges, shape.edges + shape.edgeCount, [](const Edge &edge) {
    return std::abs(std::int64_t(edge.a)) + std::abs(std::int64_t(edge.b)) <= kMax;
  });
}

bool regionOf(const Shape &shape, const Rect &bounds, Region &region) {
  region.left = bounds.x;
  region.bottom = bounds.y;
  region.right = bounds.x + bounds.width;
  region.top = bounds.y + bounds.height;
  region.count = 0;
  for (int i = 0; i < shape.edgeCount; ++i) {
    const Edge &edge = shape.edges[i];
    const EdgeOver over(edge, bounds);
    if (!over.some)
      return false;
    if (!over.all)
      region.edges[region.count++] = {edge.a, edge.b, std::int32_t(over.corner)};
  }
  return true;
}

} // namespace arbiter::swrast
