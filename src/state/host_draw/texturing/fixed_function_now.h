#pragma once
#include <cstdint>

#include "fp_compiler/fixed_function.h"

namespace arbiter::state {

class Context;

/// The host's fixed-function state that programs are chosen by, of texturing as far as the units of
/// `units` sample. Asks the host some ten to fifty values: for the choice of what is effective, not
/// for each draw.
[[nodiscard]] fp::FixedFunction fixedFunctionNow(Context &context, std::uint32_t units);

} // namespace arbiter::state
