#include "state/core/memory.h"

#include "state/core/context_hooks.h"
#include "state/core/core_context.h"
#include "state/core/errors.h"
#include "state/mirror/dirty_bits.h"

namespace arbiter::state {

void outOfMemory(CoreContext &context, const char *name) noexcept {
  raise(context, GL_OUT_OF_MEMORY, name);
  if (context.passThrough)
    return;
  context.dirty = dirty::kAll;
  invalidateProgram(context);
  // The draw may have failed half-way, so what was chosen before may not match.
  context.hooks->forgetPipeline(context);
}

} // namespace arbiter::state
