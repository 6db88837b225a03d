#include "swrast/cover/small_block.h"

namespace arbiter::swrast {

SmallCover coverSmallAvx2(const WindowVertex corner[3], bool counterclockwise, const Bounds &bounds,
                          int lanes, abi::Block *blocks) {
  return coverBlocks(corner, counterclockwise, bounds, lanes, blocks);
}

} // namespace arbiter::swrast
