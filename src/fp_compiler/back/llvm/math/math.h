#pragma once
#include "fp_compiler/back/llvm/code/code.h"

/// The functions of ops.def that are more than an instruction. Special values are those of
/// ir/semantics.h; how far the rest is from the exact result is stated here and held to by
/// math_test.cpp. Denormals count as zeros where the function runs in flush mode (engine.h).
namespace arbiter::fp::llvm_back {

/// a * b + c: rounded once where the processor can, else twice. For polynomials only; a program's
/// own MAD is two operations.
[[nodiscard]] Value *multiplyAdd(Code &code, Value *a, Value *b, Value *c);

/// 2^x within 2^-21.8 of it, to the bit as llvmpipe has it; infinity above 128, zero below -126.
[[nodiscard]] Value *exp2(Code &code, Value *x);
/// log2 x within 2^-22.5 of it; of 0 -infinity, NaN below zero.
[[nodiscard]] Value *log2(Code &code, Value *x);
/// POW of ir/semantics.h, within 2^-22 of the exact power for exponents up to 125, within 2^-19 up
/// to 2000. \param oneStaysOne Numerics::Legacy: 1^b is 1 for every b
[[nodiscard]] Value *power(Code &code, Value *base, Value *exponent, bool oneStaysOne);

struct SineCosine {
  Value *sine = nullptr, *cosine = nullptr;
};
/// Both, within 2^-23 of 1 for angles up to 2^22 in magnitude, and for those up to 2^8 within 2^-22
/// of themselves, to the bit as llvmpipe has them; of larger ones a number of [-1, 1], of an
/// infinite one NaN. What is not used costs nothing.
[[nodiscard]] SineCosine sineCosine(Code &code, Value *angle);

/// 1/x, correctly rounded.
[[nodiscard]] Value *reciprocal(Code &code, Value *x);
/// 1/sqrt|x| within 2^-22 of it.
[[nodiscard]] Value *reciprocalRoot(Code &code, Value *x);

[[nodiscard]] Value *absolute(Code &code, Value *x);
/// The other operand where one is NaN, and -0 below +0.
[[nodiscard]] Value *minimum(Code &code, Value *a, Value *b);
[[nodiscard]] Value *maximum(Code &code, Value *a, Value *b);

} // namespace arbiter::fp::llvm_back
