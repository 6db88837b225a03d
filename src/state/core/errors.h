#pragma once
#include <GL/gl.h>

#include "state/core/host_errors.h"

namespace arbiter::state {

struct CoreContext;

/// Records a GL error of the layer's (2.5). The first error since the last GetError wins. An error
/// that waits in the host was raised earlier, so it wins over this one. `why` goes to the log at
/// level info.
void raise(CoreContext &context, GLenum error, const char *why);

/// True outside Begin/End, where a command of the layer's may run. Raises INVALID_OPERATION inside
/// (2.6.3).
[[nodiscard]] bool outsideBeginEnd(CoreContext &context, const char *command);

/// Returns and clears the error for GetError: the layer's, or else the host's.
[[nodiscard]] GLenum takeError(CoreContext &context);

} // namespace arbiter::state
