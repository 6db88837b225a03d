#pragma once
#include "fp_compiler/hw/r300/lower/flow.h"

namespace arbiter::fp::hw::r300 {

/// Operations that one other operation alone reads become a part of it where the chip has a place
/// for both: a product in a sum is a MAD, a sum or difference is a presubtract, and a copy that
/// clamps or scales is done by what it copies. All of it keeps every bit, but for the sign of a
/// zero that x*2 - 1 gives.
/// Requires: prune().
void fold(Flow &flow);

} // namespace arbiter::fp::hw::r300
