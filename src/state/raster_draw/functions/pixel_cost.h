#pragma once
#include <cstdint>

#include "fp_compiler/ir/ir.h"

namespace arbiter::state {

/// Estimates the cost of a pixel on one thread in nanoseconds, at least 1: a sum over the program's
/// instructions, with loops taken once. It only decides whether other threads take part
/// (swrast::Shading::pixelCost).
[[nodiscard]] std::uint32_t pixelCost(const fp::ir::Program &program);

} // namespace arbiter::state
