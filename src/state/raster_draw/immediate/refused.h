#pragma once
#include "state/raster_draw/raster_context.h"

/// Refuses commands that are errors between Begin and End (OpenGL 2.1, 2.6.3), while a primitive is
/// recorded. Some applications set state there or nest primitives, and run on other drivers, where
/// such commands have no effect. Passing such a command to the host would give it the primitive,
/// and with it the frame.
namespace arbiter::state {

/// True if a primitive is recorded or held, so that refuses() must be asked.
[[nodiscard]] inline bool isRecorded(const ContextHot &hot) {
  return (hot.attention & (attention::kHeld | attention::kRecorded)) != 0;
}
/// Returns true if the command is an error: INVALID_OPERATION was raised, and the command is done.
/// Returns false if the command must go on. Held primitives have been drawn then. If the
/// application listens to the host's messages (KHR_debug), the host gets the primitive and reports
/// the error. Requires isRecorded().
[[nodiscard, gnu::cold]] bool refuses(ContextHot &hot, const char *command);

} // namespace arbiter::state
