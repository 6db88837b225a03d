#pragma once
#include "fp_compiler/back/llvm/code/code.h"

/// Functions of math.h in the instructions that AVX-512 has for them: parts of a float, scaling by
/// a power of two, tables in registers. Half of the instructions that others need, and the same
/// special values.
namespace arbiter::fp::llvm_back::avx512 {

/// vrangeps: minimum and maximum as ir/semantics.h has them.
[[nodiscard]] Value *extremum(Code &code, Value *a, Value *b, bool larger);
[[nodiscard]] Value *exp2(Code &code, Value *x);
[[nodiscard]] Value *log2(Code &code, Value *x);
[[nodiscard]] Value *power(Code &code, Value *base, Value *exponent, bool oneStaysOne);
[[nodiscard]] Value *reciprocalRoot(Code &code, Value *magnitude);

} // namespace arbiter::fp::llvm_back::avx512
