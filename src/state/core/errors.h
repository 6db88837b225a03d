#pragma once
#include <GL/gl.h>

#include "state/core/host_errors.h"

namespace arbiter::state {

class Context;

/// Records a GL error of the layer's (2.5). The first error since the last GetError wins, be it the
/// layer's or the host's: a host's error that waits was raised before. `why` goes to the log at
/// level info.
void raise(Context &context, GLenum error, const char *why);

/// True where a command of the layer's may run. Inside Begin/End it raises INVALID_OPERATION
/// (2.6.3).
[[nodiscard]] bool outsideBeginEnd(Context &context, const char *command);

/// GetError: the layer's, or else the host's.
[[nodiscard]] GLenum takeError(Context &context);

} // namespace arbiter::state
