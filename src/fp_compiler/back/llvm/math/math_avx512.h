#pragma once
#include "fp_compiler/back/llvm/code/code.h"

/// Functions of math.h for AVX-512: float decomposition, scaling by a power of two, tables in
/// registers. They need half of the instructions of other processors. Special values are those of
/// math.h.
namespace arbiter::fp::llvm_back::avx512 {

/// Returns the minimum or maximum as ir/semantics.h defines it (vrangeps).
[[nodiscard]] Value *extremum(Code &code, Value *a, Value *b, bool larger);
[[nodiscard]] Value *exp2(Code &code, Value *x);
[[nodiscard]] Value *log2(Code &code, Value *x);
[[nodiscard]] Value *power(Code &code, Value *base, Value *exponent, bool oneStaysOne);
[[nodiscard]] Value *reciprocalRoot(Code &code, Value *magnitude);

} // namespace arbiter::fp::llvm_back::avx512
