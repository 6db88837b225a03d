#include "state/core/memory.h"

#include "state/core/context.h"
#include "state/core/context_hooks.h"
#include "state/core/errors.h"
#include "state/mirror/dirty_bits.h"

namespace arbiter::state {

void outOfMemory(Context &context, const char *name) noexcept {
  raise(context, GL_OUT_OF_MEMORY, name);
  if (context.passThrough)
    return;
  context.dirty = software::dirty::kAll;
  invalidateProgram(context);
  // What was chosen before is not what a draw that failed half-way has left.
  context.hooks->forgetPipeline(context);
}

} // namespace arbiter::state
