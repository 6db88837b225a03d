#pragma once
#include <span>

#include "fp_compiler/back/llvm/math/math.h"

namespace arbiter::fp::llvm_back {

/// A constant of the type of \p like, in all lanes.
[[nodiscard]] inline Value *constantLike(Value *like, double value) {
  return llvm::ConstantFP::get(like->getType(), value);
}

/// The polynomial at \p x, by Horner's rule; the coefficient of the lowest power stands first.
/// Requires at least one.
template <typename Number>
[[nodiscard]] Value *polynomial(Code &code, Value *x, std::span<const Number> coefficients) {
  Value *sum = constantLike(x, double(coefficients.back()));
  for (std::size_t i = coefficients.size() - 1; i-- > 0;)
    sum = multiplyAdd(code, sum, x, constantLike(x, double(coefficients[i])));
  return sum;
}

/// An i1 a lane: where a power is 1 whatever the polynomials say: x^0 and, with \p oneStaysOne (in
/// Numerics::Legacy), 1^x.
[[nodiscard]] inline Value *isOne(Code &code, Value *base, Value *exponent, bool oneStaysOne) {
  Value *const byExponent = code.ir.CreateFCmpOEQ(exponent, code.splat(0.0f));
  if (!oneStaysOne)
    return byExponent;
  return code.ir.CreateOr(byExponent, code.ir.CreateFCmpOEQ(base, code.splat(1.0f)));
}

} // namespace arbiter::fp::llvm_back
