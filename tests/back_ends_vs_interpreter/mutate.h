#pragma once
#include <cstdint>

#include "fp_compiler/ir/ir.h"

namespace arbiter::differential {

/// Returns the program with one instruction changed. The suite must notice that it computes
/// something else. The program is optimised first, so that the instruction matters. Still, some
/// mutants compute the same (a sign under ABS, a branch never taken).
[[nodiscard]] fp::ir::Program mutant(const fp::ir::Program &program, std::uint64_t seed,
                                     fp::Numerics numerics);

} // namespace arbiter::differential
