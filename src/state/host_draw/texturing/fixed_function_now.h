#pragma once
#include <cstdint>

#include "fp_compiler/fixed_function.h"

namespace arbiter::state {

struct DrawContext;

/// Returns the host's fixed-function state that selects programs; texturing only for the units in
/// `units`. It queries ten to fifty values, so it is for choosing programs, not for each draw.
[[nodiscard]] fp::FixedFunction fixedFunctionNow(DrawContext &context, std::uint32_t units);

} // namespace arbiter::state
