#pragma once
#include "swrast/setup/shape.h"
#include "swrast/setup/small.h"

/// Which pixels are covered, block by block.
namespace arbiter::swrast {

struct Cover {
  std::uint32_t blocks = 0, pixels = 0;
};

/// What of a convex shape lies in a part of a tile, with edge functions of 32 bits.
struct Region {
  static constexpr int kSide = 64, kMostEdges = 4;
  /// Inside where a * (x - left) + b * (y - bottom) + c >= 0.
  struct Edge {
    std::int32_t a, b, c;
  };
  std::int32_t left, bottom, right, top; ///< pixels, half open, of one aligned tile of kSide
  std::int32_t count;                    ///< of the edges that cross it
  Edge edges[kMostEdges];
};
/// Whether the shape's edges fit a Region: those within any viewport do, but not those of lines and
/// rectangles that begin far outside of it.
[[nodiscard]] bool fitsRegions(const Shape &shape);
/// Of a shape that fits. False if none of the pixels is inside.
/// \param bounds pixels of one tile, some of the shape's own
[[nodiscard]] bool regionOf(const Shape &shape, const Rect &bounds, Region &region);

/// Writes the blocks of which the triangle covers a pixel, rows upwards.
/// \param part pixels of the triangle's bounds; blocks that they begin or end in are tested whole
/// \param lanes 16 (blocks of 4x4 pixels), 8 (4x2) or 4 (2x2)
/// \param blocks room for all blocks of the part and one more
using CoverSmall = Cover (*)(const SmallTriangle &triangle, const Rect &part, int lanes,
                             abi::Block *blocks);
/// The same of a region, of which nothing beyond its bounds is covered.
using CoverRegion = Cover (*)(const Region &region, int lanes, abi::Block *blocks);

struct CoverKernels {
  CoverSmall small;
  CoverRegion region;
};
/// One for each instruction set that pays; all give the same.
extern const CoverKernels kCoverBaseline;
#if defined(__x86_64__) || defined(__i386__)
extern const CoverKernels kCoverAvx2;
extern const CoverKernels kCoverAvx512;
#endif
/// The best that this processor runs.
[[nodiscard]] const CoverKernels &chooseCoverKernels();

} // namespace arbiter::swrast
