#pragma once
#include "state/core/context.h"

namespace arbiter::state {

/// Counts a copy from the current read buffer to `to`. Outside Begin/End; asks the host where the
/// copy comes from.
void trackCopy(Context &context, const TextureLevel &to, CopyKind kind, const CopyRegion &region);

} // namespace arbiter::state
