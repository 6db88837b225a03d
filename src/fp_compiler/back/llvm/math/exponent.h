#pragma once
#include "fp_compiler/back/llvm/math/polynomial.h"

/// Splits floats into exponent and mantissa and joins them by their bits, for processors without
/// instructions for it.
namespace arbiter::fp::llvm_back {

/// x as value * 2^exponent with the value in [sqrt(1/2), sqrt(2)). Undefined unless x is positive
/// and finite.
struct Mantissa {
  Value *exponent; ///< i32
  Value *value;
  Value *offset; ///< i32: the low 23 bits tell how far the value is above sqrt(1/2)
};
[[nodiscard]] Mantissa mantissaOf(Code &code, Value *x);

/// Returns 2^f for f in [0, 1], identical to llvmpipe's result.
[[nodiscard]] Value *exp2OfFraction(Code &code, Value *f);

/// Returns \p mantissa * 2^whole for a whole number of [-127, 128]. The ends of the range give zero
/// and infinity.
[[nodiscard]] Value *scaledByBits(Code &code, Value *mantissa, Value *whole);

/// Returns 2^(whole + f) for f in [0, 1]. For powers: it is more exact than exp2OfFraction().
[[nodiscard]] Value *assembled(Code &code, Value *whole, Value *f);

/// Clamps \p x, of floats or doubles, to the range of scaledByBits(). NaN stays NaN.
[[nodiscard]] Value *clampedExponent(Code &code, Value *x);

} // namespace arbiter::fp::llvm_back
