#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "fp_compiler/back/llvm/math/math.h"

namespace arbiter::fp::llvm_back {

/// A constant of the type of \p like, in all lanes.
[[nodiscard]] inline Value *constantLike(Value *like, double value) {
  return llvm::ConstantFP::get(like->getType(), value);
}

/// The polynomial at \p x, all but its lowest powers by Estrin's scheme: neighbours are joined,
/// then neighbours of these. Its longest chain has as many steps as the count has binary digits,
/// where Horner's rule has one a coefficient; processors wait for chains more than they lack units.
/// The lowest powers, which round the most, are joined one by one. The coefficient of the lowest
/// power stands first. Requires at least one.
template <typename Number>
[[nodiscard]] Value *polynomial(Code &code, Value *x, std::span<const Number> coefficients) {
  constexpr std::size_t kByOne = 2;
  const std::size_t alone = std::min(kByOne, coefficients.size() - 1);
  std::vector<Value *> terms;
  for (const Number coefficient : coefficients.subspan(alone))
    terms.push_back(constantLike(x, double(coefficient)));
  for (Value *power = x; terms.size() > 1; power = code.ir.CreateFMul(power, power)) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < terms.size(); i += 2)
      terms[count++] =
          i + 1 < terms.size() ? multiplyAdd(code, terms[i + 1], power, terms[i]) : terms[i];
    terms.resize(count);
  }
  Value *sum = terms.front();
  for (std::size_t i = alone; i-- > 0;)
    sum = multiplyAdd(code, sum, x, constantLike(x, double(coefficients[i])));
  return sum;
}

/// The polynomial as its even powers and x times its odd ones, each by Horner's rule in x * x: the
/// order in which llvmpipe evaluates, so that with its coefficients the bits are its own. Requires
/// at least two.
[[nodiscard]] inline Value *evenAndOdd(Code &code, Value *x, std::span<const float> coefficients) {
  Value *const square = code.ir.CreateFMul(x, x);
  std::array<Value *, 2> sums = {};
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    Value *const coefficient = code.splat(coefficients[i]);
    Value *&sum = sums[i % 2];
    sum = sum ? multiplyAdd(code, square, sum, coefficient) : coefficient;
  }
  return multiplyAdd(code, sums[1], x, sums[0]);
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
