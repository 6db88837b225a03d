#pragma once
#include "fp_compiler/back/llvm/code/code.h"

/// Functions of math.h in the instructions that AVX2 has for them: fused sums, a table in a
/// register, an estimate of roots. The same special values.
namespace arbiter::fp::llvm_back::avx2 {

[[nodiscard]] Value *power(Code &code, Value *base, Value *exponent, bool oneStaysOne);
[[nodiscard]] Value *reciprocalRoot(Code &code, Value *magnitude);

} // namespace arbiter::fp::llvm_back::avx2
