#pragma once
#include <cstdint>

#include "fp_compiler/ir/ir.h"

namespace arbiter::state::software {

/// What a pixel of a fragment program costs on one thread, in nanoseconds, at least 1: a rough sum
/// over its instructions, loops taken once. It decides whether other threads take part
/// (swrast::Shading::pixelCost), nothing else.
[[nodiscard]] std::uint32_t pixelCost(const fp::ir::Program &program);

} // namespace arbiter::state::software
