#pragma once
#include <cstdint>

#include "fp_compiler/ir/ir.h"

namespace arbiter::differential {

/// The program with one of its instructions computing something else: an interpreter that runs it
/// is wrong about the original, which the suite must notice. Optimised first, so that the
/// instruction matters; still, some mutants compute the same (a sign under ABS, a branch never
/// taken).
[[nodiscard]] fp::ir::Program mutant(const fp::ir::Program &program, std::uint64_t seed,
                                     fp::Numerics numerics);

} // namespace arbiter::differential
