#include "swrast/cover/small.h"

#include "swrast/cover/small_block.h"

namespace arbiter::swrast {

SmallCover coverSmallBaseline(const WindowVertex corner[3], bool counterclockwise,
                              const Bounds &bounds, int lanes, abi::Block *blocks) {
  return coverBlocks(corner, counterclockwise, bounds, lanes, blocks);
}

CoverSmall chooseCoverSmall() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("popcnt") && __builtin_cpu_supports("avx2")) {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
      return coverSmallAvx512;
    return coverSmallAvx2;
  }
#endif
  return coverSmallBaseline;
}

} // namespace arbiter::swrast
