#include "fp_compiler/back/llvm/math/math_avx2.h"

#include <limits>

#include <llvm/IR/IntrinsicsX86.h>

#include "fp_compiler/back/llvm/math/exponent.h"
#include "fp_compiler/back/llvm/math/long_log.h"

namespace arbiter::fp::llvm_back::avx2 {

namespace {
constexpr int kParts = 8;
using Table = std::array<float, kParts>;

/// A factor and its logarithm for each eighth of the mantissas of [sqrt(1/2), sqrt(2)). The factor
/// has so few bits that the product is exact, and brings it to within 1/16 of 1. The negated
/// logarithm is in two parts, the first a multiple of 2^-16. The factor near 1 is 1, so that powers
/// of such a base keep full accuracy.
constexpr Table kFactor = {22 / 16.0f, 20 / 16.0f, 19 / 16.0f, 17 / 16.0f,
                           1.0f,       29 / 32.0f, 26 / 32.0f, 24 / 32.0f};
constexpr Table kFactorLog = {-0x1.d674p-2f, -0x1.49a8p-2f, -0x1.fbc0p-3f, -0x1.6640p-4f,
                              0.0f,          0x1.22d8p-3f,  0x1.32c0p-2f,  0x1.a900p-2f};
constexpr Table kFactorLogRest = {
    -0x1.3e032ep-18f, 0x1.ed0cbap-20f,  -0x1.6b9026p-19f, 0x1.20a6dep-21f, 0.0f,
    0x1.6e155ap-18f,  -0x1.1c8f12p-22f, -0x1.a39fbep-20f};
/// Coefficients within 2^-34.4 of log2(1 + t) for t in [-0.0583, 0.0626], minimax (Remez exchange).
constexpr float kTail[] = {-0x1.715476p-1f, 0x1.ec7052p-2f, -0x1.715614p-2f, 0x1.2884ccp-2f,
                           -0x1.e9aba8p-3f};
constexpr LogPolynomial kLog2 = {0x1.715476p+0f, 0x1.4ae0cp-26f, kTail};

/// Returns element `index` modulo kParts of a table.
Value *lookUp(Code &code, const Table &table, Value *index) {
  llvm::SmallVector<llvm::Constant *, kParts> values;
  for (const float value : table)
    values.push_back(llvm::ConstantFP::get(code.ir.getFloatTy(), double(value)));
  return code.ir.CreateIntrinsic(llvm::Intrinsic::x86_avx2_permps, {},
                                 {llvm::ConstantVector::get(values), index});
}

/// Returns log2 x of a positive finite number to some 30 bits.
Long longLog2(Code &code, Value *x) {
  llvm::IRBuilder<> &ir = code.ir;
  const Mantissa parts = mantissaOf(code, x);
  constexpr int kPartShift = 20; // keeps the mantissa's three upper bits
  Value *const part = ir.CreateLShr(parts.offset, code.splat(kPartShift));
  Value *const r = multiplyAdd(code, parts.value, lookUp(code, kFactor, part), code.splat(-1.0f));
  return llvm_back::longLog2(
      code,
      {ir.CreateFAdd(code.toFloat(parts.exponent), lookUp(code, kFactorLog, part)),
       lookUp(code, kFactorLogRest, part), r},
      kLog2);
}
} // namespace

Value *power(Code &code, Value *base, Value *exponent, bool oneStaysOne) {
  llvm::IRBuilder<> &ir = code.ir;
  Long logarithm = longLog2(code, base);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  logarithm.high = code.select(ir.CreateFCmpOEQ(base, code.splat(kInfinity)), code.splat(kInfinity),
                               logarithm.high);
  Value *const product = ir.CreateFMul(exponent, logarithm.high);
  Value *const error = multiplyAdd(code, exponent, logarithm.high, ir.CreateFNeg(product));
  Value *tail = multiplyAdd(code, exponent, logarithm.low, error);
  // The rest of an infinite or far too large product is meaningless, so it is dropped.
  tail =
      code.select(ir.CreateFCmpOLT(absolute(code, tail), code.splat(1.0f)), tail, code.splat(0.0f));
  Value *const inRange = clampedExponent(code, product);
  Value *const whole = code.floor(inRange);
  Value *const result = assembled(code, whole, ir.CreateFAdd(ir.CreateFSub(inRange, whole), tail));
  Value *const zero = code.splat(0.0f);
  Value *const powered = code.select(ir.CreateFCmpOGT(base, zero), result, zero);
  return code.select(isOne(code, base, exponent, oneStaysOne), code.splat(1.0f), powered);
}

Value *reciprocalRoot(Code &code, Value *magnitude) {
  // An estimate y of 11 bits is 1/sqrt(m) * sqrt(1 - e) with e = 1 - m y^2. Two terms of the series
  // for 1/sqrt(1 - e) correct it to full accuracy. For 0 and infinity the error is NaN, but the
  // estimate is exact.
  llvm::IRBuilder<> &ir = code.ir;
  Value *const y = ir.CreateIntrinsic(llvm::Intrinsic::x86_avx_rsqrt_ps_256, {}, {magnitude});
  Value *const error =
      multiplyAdd(code, ir.CreateFNeg(ir.CreateFMul(magnitude, y)), y, code.splat(1.0f));
  // The two factors are independent, so that neither waits for the other.
  Value *const correction = ir.CreateFMul(y, error);
  Value *const terms = multiplyAdd(code, error, code.splat(0.375f), code.splat(0.5f));
  return code.select(ir.CreateFCmpUNO(error, error), y, multiplyAdd(code, correction, terms, y));
}

} // namespace arbiter::fp::llvm_back::avx2
