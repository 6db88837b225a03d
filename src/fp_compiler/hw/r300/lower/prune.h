#pragma once
#include "fp_compiler/hw/r300/lower/flow.h"

namespace arbiter::fp::hw::r300 {

/// Removes dead code: clears `live` of unread items, and trims masks to the components that are
/// read. Also chooses the halves that a replicated operation needs, and makes each web's root its
/// items' parent.
void prune(Flow &flow);

} // namespace arbiter::fp::hw::r300
