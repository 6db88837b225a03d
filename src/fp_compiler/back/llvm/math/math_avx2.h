#pragma once
#include "fp_compiler/back/llvm/code/code.h"

/// Functions of math.h for AVX2: fused multiply-adds, a table in a register, an estimate of roots.
/// Special values are those of math.h.
namespace arbiter::fp::llvm_back::avx2 {

[[nodiscard]] Value *power(Code &code, Value *base, Value *exponent, bool oneStaysOne);
[[nodiscard]] Value *reciprocalRoot(Code &code, Value *magnitude);

} // namespace arbiter::fp::llvm_back::avx2
