#pragma once
#include "fp_compiler/back/llvm/math/polynomial.h"

/// Logarithms as the sum of two floats, for powers. The product with an exponent as large as 128
/// would lose the last bits of a single float.
namespace arbiter::fp::llvm_back {

/// A sum of two floats.
struct Long {
  Value *high, *low;
};

/// x as 2^coarse * (1 + r), from a table of factors.
struct FactoredLog {
  Value *coarse; ///< exact: a whole number plus a multiple of 2^-16
  Value *rest;   ///< the remainder of the coarse logarithm
  Value *r;      ///< small: 0, or too small to cancel the coarse part
};

/// A polynomial: log2(1 + t) is t * (first + firstRest) + t^2 * tail(t).
struct LogPolynomial {
  float first, firstRest;
  std::span<const float> tail;
};

/// Returns log2 of the value that \p x represents.
[[nodiscard]] inline Long longLog2(Code &code, const FactoredLog &x, const LogPolynomial &by) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *const first = ir.CreateFMul(x.r, code.splat(by.first));
  Value *const firstError = multiplyAdd(code, x.r, code.splat(by.first), ir.CreateFNeg(first));
  Value *rest = ir.CreateFAdd(firstError, x.rest);
  rest = multiplyAdd(code, x.r, code.splat(by.firstRest), rest);
  rest = multiplyAdd(code, ir.CreateFMul(x.r, x.r), polynomial<float>(code, x.r, by.tail), rest);
  // The larger operand comes first (the coarse part, unless it is zero), so that the difference is
  // the sum's error. The low part must contain only that error. Multiplied by an exponent of
  // hundreds, it would otherwise exceed the fraction that powers are made from.
  const auto sumOf = [&](Value *larger, Value *smaller) -> Long {
    Value *const sum = ir.CreateFAdd(larger, smaller);
    return {sum, ir.CreateFSub(smaller, ir.CreateFSub(sum, larger))};
  };
  const Long fine = sumOf(first, rest);
  const Long all = sumOf(x.coarse, fine.high);
  return {all.high, ir.CreateFAdd(all.low, fine.low)};
}

} // namespace arbiter::fp::llvm_back
