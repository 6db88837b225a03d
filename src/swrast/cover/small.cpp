#include "swrast/cover/small.h"

#include "swrast/cover/small_block.h"
#include "util/processor.h"

namespace arbiter::swrast {

SmallCover coverSmallBaseline(const WindowVertex corner[3], bool counterclockwise,
                              const Bounds &bounds, int lanes, abi::Block *blocks) {
  return coverBlocks(corner, counterclockwise, bounds, lanes, blocks);
}

CoverSmall chooseCoverSmall() {
#if defined(__x86_64__) || defined(__i386__)
  if (vectors() == Vectors::Avx512)
    return coverSmallAvx512;
  if (vectors() == Vectors::Avx2)
    return coverSmallAvx2;
#endif
  return coverSmallBaseline;
}

} // namespace arbiter::swrast
