#pragma once
#include "state/context.h"

namespace arbiter::state {

/// Counts a copy from the current read buffer to `to`. Outside Begin/End; asks the host where the
/// copy comes from.
void trackCopy(Context &context, const swrast::TextureLevel &to, swrast::CopyKind kind,
               const swrast::CopyRegion &region);
/// The query of what is bound to a target of CopyTexImage; 0 where there is no such target.
[[nodiscard]] GLenum bindingOf(GLenum target);

} // namespace arbiter::state
