#pragma once
#include "swrast/setup/shape.h"
#include "swrast/setup/small.h"

/// Finds which pixels a primitive covers, block by block.
namespace arbiter::swrast {

struct Cover {
  std::uint32_t blocks = 0, pixels = 0;
};

/// The part of a convex shape in one tile, with 32-bit edge functions.
struct Region {
  static constexpr int kSide = 64, kMaxEdges = 4;
  /// A pixel is inside if a * (x - left) + b * (y - bottom) + c >= 0.
  struct Edge {
    std::int32_t a, b, c;
  };
  std::int32_t left, bottom, right, top; ///< pixels of one aligned tile of kSide, half-open
  std::int32_t count;                    ///< number of edges that cross the region
  Edge edges[kMaxEdges];
};
/// True if the shape's edges fit a Region. Edges within any viewport do. Those of lines and
/// rectangles that begin far outside of it do not.
[[nodiscard]] bool fitsRegions(const Shape &shape);
/// Makes the region of a shape for which fitsRegions() is true. Returns false if none of the pixels
/// is inside.
/// \param bounds pixels of one tile, within the shape's own bounds
[[nodiscard]] bool regionOf(const Shape &shape, const Rect &bounds, Region &region);

/// Writes the blocks in which the triangle covers a pixel, row by row upwards.
/// \param part pixels within the triangle's bounds; blocks at its border are tested whole
/// \param lanes 16 (blocks of 4x4 pixels), 8 (4x2) or 4 (2x2)
/// \param blocks room for all blocks of the part and one more
using CoverSmall = Cover (*)(const SmallTriangle &triangle, const Rect &part, int lanes,
                             abi::Block *blocks);
/// Writes the blocks in which a region is covered, as CoverSmall does. Pixels outside the region's
/// bounds are never covered.
using CoverRegion = Cover (*)(const Region &region, int lanes, abi::Block *blocks);

struct CoverKernels {
  CoverSmall small;
  CoverRegion region;
};
/// One set of kernels for each useful instruction set. All give the same results.
extern const CoverKernels kCoverBaseline;
#if defined(__x86_64__) || defined(__i386__)
extern const CoverKernels kCoverAvx2;
extern const CoverKernels kCoverAvx512;
#endif
/// Returns the best kernels for this processor.
[[nodiscard]] const CoverKernels &chooseCoverKernels();

} // namespace arbiter::swrast
