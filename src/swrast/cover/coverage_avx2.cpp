#include "swrast/cover/coverage_block.h"

namespace arbiter::swrast {

const CoverKernels kCoverAvx2 = {coverSmallBlocks, coverRegionBlocks};

} // namespace arbiter::swrast
