#pragma once
#include <cstdint>

#include "fp_compiler/ir/ir.h"

/// How often loops run, as far as a program's text says.
namespace arbiter::fp::ir {

/// A REP's iterations; kMostIterations where a constant does not say.
[[nodiscard]] std::uint64_t mostIterations(const Program &program, const Instruction &repeat);

/// True if constants keep all loops together from kMostIterations.
[[nodiscard]] bool endsByItself(const Program &program);

} // namespace arbiter::fp::ir
