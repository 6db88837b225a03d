#pragma once
#include "fp_compiler/back/llvm/code/code.h"

/// The functions of ops.def that need more than one instruction. Special values are those of
/// ir/semantics.h. The error bounds stated here are checked by math_test.cpp. Denormals count as
/// zeros where the function runs in flush mode (engine.h).
namespace arbiter::fp::llvm_back {

/// Returns a * b + c, rounded once if the processor can, else twice. For polynomials only, because
/// a program's MAD is two operations.
[[nodiscard]] Value *multiplyAdd(Code &code, Value *a, Value *b, Value *c);

/// Returns 2^x within a relative error of 2^-21.8, identical to llvmpipe's result. Infinity above
/// 128, zero below -126.
[[nodiscard]] Value *exp2(Code &code, Value *x);
/// Returns log2 x within 2^-22.5. Zero gives -infinity; negative numbers give NaN.
[[nodiscard]] Value *log2(Code &code, Value *x);
/// Returns POW of ir/semantics.h. The relative error is within 2^-22 for exponents up to 125, and
/// within 2^-19 up to 2000.
/// \param oneStaysOne true for Numerics::Legacy: 1^b is 1 for every b
[[nodiscard]] Value *power(Code &code, Value *base, Value *exponent, bool oneStaysOne);

struct SineCosine {
  Value *sine = nullptr, *cosine = nullptr;
};
/// Returns sine and cosine. The absolute error is within 2^-23 for angles up to 2^22 in magnitude.
/// Up to 2^8 the relative error is within 2^-22, and results are identical to llvmpipe's. Larger
/// angles give a number of [-1, 1], and infinite ones NaN. An unused result costs nothing.
[[nodiscard]] SineCosine sineCosine(Code &code, Value *angle);

/// Returns 1/x, correctly rounded.
[[nodiscard]] Value *reciprocal(Code &code, Value *x);
/// Returns 1/sqrt|x| within a relative error of 2^-22.
[[nodiscard]] Value *reciprocalRoot(Code &code, Value *x);

[[nodiscard]] Value *absolute(Code &code, Value *x);
/// These return the other operand if one is NaN. -0 is less than +0.
[[nodiscard]] Value *minimum(Code &code, Value *a, Value *b);
[[nodiscard]] Value *maximum(Code &code, Value *a, Value *b);

} // namespace arbiter::fp::llvm_back
