#pragma once
#include "state/core/context_hooks.h"

namespace arbiter::state {

/// The hooks of every context but the null context.
extern const ContextHooks kContextHooks;

} // namespace arbiter::state
