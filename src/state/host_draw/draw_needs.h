#pragma once
#include <cstdint>

#include "state/host_draw/draw_context.h"

namespace arbiter::state {

/// Returns the needs that last a while (core/draw_needs.def) and hold now: bits of
/// ContextHot::attention.
[[nodiscard]] std::uint32_t lastingNeeds(const DrawContext &context);

} // namespace arbiter::state
