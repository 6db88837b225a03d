#pragma once
#include "state/core/context.h"

/// Commands that are errors between Begin and End (OpenGL 2.1, 2.6.3), while a primitive is
/// recorded: applications that set state there, or open a primitive in a primitive, run on other
/// drivers, where nothing comes of it. Given to the host, such a command would take the primitive
/// with it, and with the primitive the frame.
namespace arbiter::state::software {

/// A primitive is recorded, or held: refuses() says what follows.
[[nodiscard]] inline bool isRecorded(const ContextHot &hot) {
  return (hot.attention & (attention::kHeld | attention::kRecorded)) != 0;
}
/// True: the command is an error, and INVALID_OPERATION was raised; nothing else comes of it.
/// False: it goes its way. A primitive that is held has been drawn, and one whose application
/// listens to the host's messages (KHR_debug) is the host's, which tells of the error.
/// Requires: isRecorded().
[[nodiscard, gnu::cold]] bool refuses(ContextHot &hot, const char *command);

} // namespace arbiter::state::software
