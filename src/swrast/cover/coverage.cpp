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
  // An edge that crosses a tile of 64 pixels is at most (|a| + |b|) * 63 from 0 in it, and the
  // kernels look up to a tile and a block further: 1.5 * 2^23 * 131 < 2^31.
  constexpr std::int64_t kMost = std::int64_t(3) << 22;
  return std::all_of(shape.edges, shape.edges + shape.edgeCount, [](const Edge &edge) {
    return std::abs(std::int64_t(edge.a)) + std::abs(std::int64_t(edge.b)) <= kMost;
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
    const std::int64_t at =
        edge.a * std::int64_t(bounds.x) + edge.b * std::int64_t(bounds.y) + edge.c;
    const std::int64_t alongX = edge.a * std::int64_t(bounds.width - 1);
    const std::int64_t alongY = edge.b * std::int64_t(bounds.height - 1);
    const std::int64_t zero = 0;
    if (at + std::max(alongX, zero) + std::max(alongY, zero) < 0)
      return false;
    if (at + std::min(alongX, zero) + std::min(alongY, zero) < 0)
      region.edges[region.count++] = {edge.a, edge.b, std::int32_t(at)};
  }
  return true;
}

} // namespace arbiter::swrast
