#pragma once
#include "fp_compiler/hw/r300/lower/flow.h"

namespace arbiter::fp::hw::r300 {

/// Merges an operation that has a single reader into that reader if the chip can do both at once. A
/// product in a sum becomes a MAD, and a sum or difference a presubtract. A copy that clamps or
/// scales is merged with what it copies. Results keep every bit, except the sign of a zero from x*2
/// - 1.
/// Requires: prune().
void fold(Flow &flow);

} // namespace arbiter::fp::hw::r300
