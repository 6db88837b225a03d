#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "fp_compiler/back/llvm/math/math.h"

namespace arbiter::fp::llvm_back {

/// Returns a constant of the type of \p like, in all lanes.
[[nodiscard]] inline Value *constantLike(Value *like, double value) {
  return llvm::ConstantFP::get(like->getType(), value);
}

/// Evaluates a polynomial at \p x, mostly by Estrin's scheme: it joins neighbouring terms, then
/// neighbours of these. The longest dependency chain is the number of binary digits of the count,
/// where Horner's rule needs one step for each coefficient. Latency costs more than the extra
/// operations. The lowest powers dominate the rounding error and are added one by one. The
/// coefficient of the lowest power comes first. Requires: there is at least one.
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

/// Evaluates a polynomial as its even powers plus x times its odd powers, each by Horner's rule in
/// x * x. llvmpipe uses this order, so that with its coefficients the results are identical.
/// Requires: there are at least two coefficients.
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

/// Returns an i1 for each lane: true where a power is 1 by definition. This is x^0 and, with \p
/// oneStaysOne (Numerics::Legacy), 1^x.
[[nodiscard]] inline Value *isOne(Code &code, Value *base, Value *exponent, bool oneStaysOne) {
  Value *const byExponent = code.ir.CreateFCmpOEQ(exponent, code.splat(0.0f));
  if (!oneStaysOne)
    return byExponent;
  return code.ir.CreateOr(byExponent, code.ir.CreateFCmpOEQ(base, code.splat(1.0f)));
}

} // namespace arbiter::fp::llvm_back
