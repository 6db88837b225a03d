#pragma once
#include "fp_compiler/back/llvm/math/polynomial.h"

/// Floats taken apart and put together by their bits, for processors without instructions for it.
namespace arbiter::fp::llvm_back {

/// x as value * 2^exponent with the value in [sqrt(1/2), sqrt(2)); anything for what is no positive
/// finite number.
struct Mantissa {
  Value *exponent; ///< i32
  Value *value;
  Value *offset; ///< i32: in its low 23 bits how far the value lies above sqrt(1/2)
};
[[nodiscard]] Mantissa mantissaOf(Code &code, Value *x);

/// 2^f for f in [0, 1], to the bit as llvmpipe has it.
[[nodiscard]] Value *exp2OfFraction(Code &code, Value *f);

/// \p mantissa * 2^whole for a whole number of [-127, 128]: zero at the lower end, infinity at the
/// upper one.
[[nodiscard]] Value *scaledByBits(Code &code, Value *mantissa, Value *whole);

/// The same of 2^f for f in [0, 1], for powers: closer than exp2OfFraction().
[[nodiscard]] Value *assembled(Code &code, Value *whole, Value *f);

/// In the range that scaledByBits() takes; NaN stays NaN. Floats or doubles.
[[nodiscard]] Value *clampedExponent(Code &code, Value *x);

} // namespace arbiter::fp::llvm_back
