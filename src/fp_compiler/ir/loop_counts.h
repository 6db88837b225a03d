#pragma once
#include <cstdint>

#include "fp_compiler/ir/ir.h"

/// Finds how often loops run, as far as a program's constants tell.
namespace arbiter::fp::ir {

/// Returns the iterations of a REP, or kMaxIterations if its count is not a constant.
[[nodiscard]] std::uint64_t mostIterations(const Program &program, const Instruction &repeat);

/// True if constants keep the iterations of all loops together below kMaxIterations.
[[nodiscard]] bool endsByItself(const Program &program);

} // namespace arbiter::fp::ir
