#pragma once
#include "fp_compiler/back/llvm/math/polynomial.h"

/// Logarithms in two floats, for powers: a product with an exponent as large as 128 would lose a
/// single's last bits.
namespace arbiter::fp::llvm_back {

/// A sum in two parts.
struct Long {
  Value *high, *low;
};

/// x as 2^coarse * (1 + r), as a table of factors gives it.
struct FactoredLog {
  Value *coarse; ///< a whole number and a multiple of 2^-16: exact
  Value *rest;   ///< of the coarse logarithm
  Value *r;      ///< small; 0, or smaller than the coarse part makes it count
};

/// log2(1 + t) as t * (first + firstRest) + t^2 * tail(t).
struct LogPolynomial {
  float first, firstRest;
  std::span<const float> tail;
};

/// log2 of what \p x stands for.
[[nodiscard]] inline Long longLog2(Code &code, const FactoredLog &x, const LogPolynomial &by) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *const first = ir.CreateFMul(x.r, code.splat(by.first));
  Value *const firstError = multiplyAdd(code, x.r, code.splat(by.first), ir.CreateFNeg(first));
  Value *rest = ir.CreateFAdd(firstError, x.rest);
  rest = multiplyAdd(code, x.r, code.splat(by.firstRest), rest);
  rest = multiplyAdd(code, ir.CreateFMul(x.r, x.r), polynomial<float>(code, x.r, by.tail), rest);
  // Of two numbers the larger, and the coarse part if it is not zero, stands first, so that the
  // difference is the sum's error. The low part has to be as low as that: times an exponent of
  // hundreds it would reach out of the fraction that powers are made from.
  const auto sumOf = [&](Value *larger, Value *smaller) -> Long {
    Value *const sum = ir.CreateFAdd(larger, smaller);
    return {sum, ir.CreateFSub(smaller, ir.CreateFSub(sum, larger))};
  };
  const Long fine = sumOf(first, rest);
  const Long all = sumOf(x.coarse, fine.high);
  return {all.high, ir.CreateFAdd(all.low, fine.low)};
}

} // namespace arbiter::fp::llvm_back
