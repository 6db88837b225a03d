#pragma once
#include <GL/gl.h>

#include "state/core/host_errors.h"

namespace arbiter::state {

class Context;

/// Records a GL error of ours (2.5). The first error since the last GetError wins, be it ours or
/// the host's: a host's error that waits was raised before. `why` goes to the log at level info.
void raise(Context &context, GLenum error, const char *why);

/// GetError: ours, or else the host's.
[[nodiscard]] GLenum takeError(Context &context);

} // namespace arbiter::state
