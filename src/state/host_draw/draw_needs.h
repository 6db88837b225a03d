#pragma once
#include <cstdint>

#include "state/core/context.h"

namespace arbiter::state {

/// Returns the needs that last a while (core/draw_needs.def) and hold now: bits of
/// ContextHot::attention.
[[nodiscard]] std::uint32_t lastingNeeds(const Context &context);

} // namespace arbiter::state
