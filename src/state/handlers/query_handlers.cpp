#include "host/handlers.h"
#include "state/lists/conditional_commands.h"

namespace arbiter::state::handlers {

void BeginConditionalRender(Context &context, GLuint id, GLenum mode) {
  issueBeginConditional(context, id, mode);
}

void EndConditionalRender(Context &context) { issueEndConditional(context); }

} // namespace arbiter::state::handlers
