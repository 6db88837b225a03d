// Conditional rendering, which GL has no query for. The layer assumes that it has begun even if the
// host refused it: until its end the host draws, which is always right. In lists that the layer
// keeps it is a command of the layer's.
#include "host/handlers.h"
#include "state/context/context.h"
#include "state/lists/conditional_commands.h"

namespace arbiter::state::handlers {

void BeginConditionalRender(Context &context, GLuint id, GLenum mode) {
  issueBeginConditional(context, id, mode);
}

void EndConditionalRender(Context &context) { issueEndConditional(context); }

} // namespace arbiter::state::handlers
