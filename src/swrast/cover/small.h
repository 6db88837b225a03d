#pragma once
#include "swrast/setup/shape.h"

/// Coverage of small triangles, block by block.
namespace arbiter::swrast {

/// Triangles whose snapped corners are less than this apart, in x and in y: their edge functions
/// fit 32 bits near them.
inline constexpr std::int32_t kSmallExtent = 64 * kSubpixels;

struct SmallCover {
  std::uint32_t blocks = 0, pixels = 0;
};

/// Writes the blocks of which the triangle covers a pixel, rows upwards.
/// \param bounds pixels; blocks that they begin or end in are tested whole
/// \param lanes 16 (blocks of 4x4 pixels), 8 (4x2) or 4 (2x2)
/// \param blocks room for all blocks of the bounds and one more
using CoverSmall = SmallCover (*)(const WindowVertex corner[3], bool counterclockwise,
                                  const Bounds &bounds, int lanes, abi::Block *blocks);

/// One for each instruction set that pays; all give the same.
SmallCover coverSmallBaseline(const WindowVertex corner[3], bool counterclockwise,
                              const Bounds &bounds, int lanes, abi::Block *blocks);
SmallCover coverSmallAvx2(const WindowVertex corner[3], bool counterclockwise, const Bounds &bounds,
                          int lanes, abi::Block *blocks);
SmallCover coverSmallAvx512(const WindowVertex corner[3], bool counterclockwise,
                            const Bounds &bounds, int lanes, abi::Block *blocks);
/// The best that this processor runs.
[[nodiscard]] CoverSmall chooseCoverSmall();

} // namespace arbiter::swrast
