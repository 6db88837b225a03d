#include "swrast/cover/coverage_block.h"

namespace arbiter::swrast {

const CoverKernels kCoverAvx512 = {coverSmallBlocks, coverRegionBlocks};

} // namespace arbiter::swrast
