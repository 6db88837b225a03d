#pragma once
#include "fp_compiler/hw/r300/lower/flow.h"

namespace arbiter::fp::hw::r300 {

/// Marks what nothing reads as not live, trims masks to the components that are read, chooses
/// which halves a replicated operation needs, and makes every web's root its items' parent.
void prune(Flow &flow);

} // namespace arbiter::fp::hw::r300
