#include "fp_compiler/back/llvm/math/math_avx512.h"

#include <llvm/IR/IntrinsicsX86.h>

#include "fp_compiler/back/llvm/math/exponent.h"
#include "fp_compiler/back/llvm/math/long_log.h"

namespace arbiter::fp::llvm_back::avx512 {

namespace {
// The polynomials are minimax for the relative error (Remez exchange), lowest power first.

/// Coefficients of (2^f - 1) / f for f in [-1/2, 1/2]: 1 + f * p is within 2^-28.8 of 2^f.
constexpr float kExp2Centred[] = {0x1.62e430p-1f, 0x1.ebfbdap-3f,  0x1.c6aed4p-5f,
                                  0x1.3b2dbcp-7f, 0x1.5f456ap-10f, 0x1.41d32ep-13f};
/// Coefficients of log2(1 + t) / t for t in [-1/4, 1/2], within 2^-25.1.
constexpr float kLog2[] = {0x1.715476p+0f,  -0x1.715496p-1f, 0x1.ec7198p-2f,
                           -0x1.713ad0p-2f, 0x1.271bacp-2f,  -0x1.f11906p-3f,
                           0x1.bb088ep-3f,  -0x1.64d2e0p-3f, 0x1.3fc300p-4f};
/// Coefficients of log2(1 + t) / t for t in [-1/32, 1/32], within 2^-31.5. The first coefficient is
/// in two parts.
constexpr float kLog2First = 0x1.715476p+0f, kLog2FirstRest = 0x1.4af6c2p-26f;
constexpr float kLog2Tail[] = {-0x1.715474p-1f, 0x1.ec7096p-2f, -0x1.71a178p-2f, 0x1.27c3c8p-2f};

/// A factor and its logarithm for each 32nd part of [1, 2). The factor has 8 bits and brings the
/// mantissa to within 1/32 of 1. The negated logarithm is in two parts, the first a multiple of
/// 2^-16. At both ends factor and logarithm are exact, so that powers of a base near 1 keep full
/// accuracy.
constexpr int kParts = 32;
using Table = std::array<float, kParts>;
constexpr Table kFactor = {
    0x1.00p+0f, 0x1.eap-1f, 0x1.dap-1f, 0x1.cep-1f, 0x1.c0p-1f, 0x1.b4p-1f, 0x1.aap-1f, 0x1.9ep-1f,
    0x1.94p-1f, 0x1.8ap-1f, 0x1.82p-1f, 0x1.78p-1f, 0x1.70p-1f, 0x1.68p-1f, 0x1.60p-1f, 0x1.58p-1f,
    0x1.52p-1f, 0x1.4ap-1f, 0x1.44p-1f, 0x1.3ep-1f, 0x1.38p-1f, 0x1.32p-1f, 0x1.2cp-1f, 0x1.28p-1f,
    0x1.22p-1f, 0x1.1cp-1f, 0x1.18p-1f, 0x1.14p-1f, 0x1.0ep-1f, 0x1.0ap-1f, 0x1.06p-1f, 0x1.00p-1f};
constexpr Table kFactorLog = {0x0.0p+0f,    0x1.0380p-4f, 0x1.c7b0p-4f, 0x1.2fa0p-3f, 0x1.8a88p-3f,
                              0x1.dac0p-3f, 0x1.0fa8p-2f, 0x1.39e0p-2f, 0x1.5dfcp-2f, 0x1.8304p-2f,
                              0x1.a154p-2f, 0x1.c818p-2f, 0x1.e7e0p-2f, 0x1.042cp-1f, 0x1.14c6p-1f,
                              0x1.25c0p-1f, 0x1.32c0p-1f, 0x1.4472p-1f, 0x1.5200p-1f, 0x1.5fcep-1f,
                              0x1.6de0p-1f, 0x1.7c38p-1f, 0x1.8ad8p-1f, 0x1.94c2p-1f, 0x1.a3e2p-1f,
                              0x1.b354p-1f, 0x1.bdcep-1f, 0x1.c870p-1f, 0x1.d8acp-1f, 0x1.e3b2p-1f,
                              0x1.eee4p-1f, 0x1.0000p+0f};
constexpr Table kFactorLogRest = {
    0x0.0p+0f,        0x1.fbef2ap-18f,  0x1.4a2dc4p-18f,  -0x1.cd2a40p-19f, 0x1.80abfcp-19f,
    0x1.169f22p-18f,  0x1.20112cp-20f,  -0x1.71eaa6p-18f, 0x1.cf1eeap-18f,  0x1.b21824p-19f,
    -0x1.0ebd68p-18f, 0x1.dc2d46p-18f,  -0x1.40358ep-19f, -0x1.5a32c2p-20f, -0x1.3e032ep-18f,
    0x1.408c78p-18f,  -0x1.1c8f12p-21f, -0x1.2ba7f0p-18f, -0x1.a39fbep-18f, -0x1.8ec6c2p-20f,
    -0x1.eac382p-20f, -0x1.5b7606p-19f, 0x1.1b3cdap-19f,  0x1.0e9258p-18f,  0x1.e95888p-18f,
    0x1.61d876p-19f,  0x1.3b992cp-18f,  -0x1.0902b6p-18f, -0x1.7ee940p-19f, 0x1.51bd56p-23f,
    -0x1.a3aa26p-18f, 0x0.0p+0f};

enum class Interval : unsigned { FromOne = 0, FromThreeQuarters = 3 };

/// Calls a masked intrinsic with all lanes enabled, in the current rounding mode.
template <typename... Arguments>
Value *whole(Code &code, llvm::Intrinsic::ID id, Arguments... arguments) {
  constexpr unsigned kCurrentRounding = 4;
  return code.ir.CreateIntrinsic(id, {},
                                 {arguments..., llvm::Constant::getNullValue(code.f32),
                                  code.ir.getInt16(0xFFFF), code.ir.getInt32(kCurrentRounding)});
}

/// Returns the mantissa in an interval. Zero and infinity give 1; negative numbers give NaN.
Value *mantissa(Code &code, Value *x, Interval interval) {
  constexpr unsigned kNanBelowZero = 0xC;
  return whole(code, llvm::Intrinsic::x86_avx512_mask_getmant_ps_512, x,
               code.ir.getInt32(unsigned(interval) | kNanBelowZero));
}
/// Returns floor(log2 |x|) as a float. Zero and infinity give -infinity and infinity.
Value *exponentOf(Code &code, Value *x) {
  return whole(code, llvm::Intrinsic::x86_avx512_mask_getexp_ps_512, x);
}
/// Returns x * 2^floor(n). Out of range, and for infinite n, it is infinity or zero.
Value *scaled(Code &code, Value *x, Value *n) {
  return whole(code, llvm::Intrinsic::x86_avx512_mask_scalef_ps_512, x, n);
}

Value *range(Code &code, Value *a, Value *b, unsigned what) {
  return whole(code, llvm::Intrinsic::x86_avx512_mask_range_ps_512, a, b, code.ir.getInt32(what));
}

/// Returns element `index` modulo kParts of a table that stays in two registers.
Value *lookUp(Code &code, const Table &table, Value *index) {
  const auto half = [&](int from) {
    llvm::SmallVector<llvm::Constant *, 16> values;
    for (int i = 0; i < kParts / 2; ++i)
      values.push_back(
          llvm::ConstantFP::get(code.ir.getFloatTy(), double(table[std::size_t(from + i)])));
    return llvm::ConstantVector::get(values);
  };
  return code.ir.CreateIntrinsic(llvm::Intrinsic::x86_avx512_vpermi2var_ps_512, {},
                                 {half(0), index, half(kParts / 2)});
}

/// Returns log2 x of a positive number to some 30 bits. For infinity only the high part is defined.
Long longLog2(Code &code, Value *x) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *const m = mantissa(code, x, Interval::FromOne);
  constexpr int kPartShift = 18; // keeps the mantissa's five upper bits
  Value *const part = ir.CreateLShr(ir.CreateBitCast(m, code.i32), code.splat(kPartShift));
  Value *const r = multiplyAdd(code, m, lookUp(code, kFactor, part), code.splat(-1.0f));
  return llvm_back::longLog2(code,
                             {ir.CreateFAdd(exponentOf(code, x), lookUp(code, kFactorLog, part)),
                              lookUp(code, kFactorLogRest, part), r},
                             {kLog2First, kLog2FirstRest, kLog2Tail});
}
} // namespace

Value *extremum(Code &code, Value *a, Value *b, bool larger) {
  constexpr unsigned kSignOfResult = 4;
  return range(code, a, b, kSignOfResult | (larger ? 1u : 0u));
}

Value *exp2(Code &code, Value *x) {
  // The subtraction rounds to nearest, unlike vreduceps rounding down. An infinity has no fraction,
  // so any value will do.
  Value *const fraction = code.ir.CreateFSub(x, code.floor(x));
  Value *const f =
      code.select(code.ir.CreateFCmpOLT(fraction, code.splat(1.0f)), fraction, code.splat(1.0f));
  return scaled(code, exp2OfFraction(code, f), x);
}

Value *log2(Code &code, Value *x) {
  Value *const m = mantissa(code, x, Interval::FromThreeQuarters);
  // In that interval, the upper half of the mantissas belongs to the next exponent.
  Value *const below = code.ir.CreateFCmpOLT(m, code.splat(1.0f));
  Value *const floor = exponentOf(code, x);
  Value *const exponent = code.select(below, code.ir.CreateFAdd(floor, code.splat(1.0f)), floor);
  Value *const t = code.ir.CreateFSub(m, code.splat(1.0f));
  return multiplyAdd(code, t, polynomial<float>(code, t, kLog2), exponent);
}

Value *power(Code &code, Value *base, Value *exponent, bool oneStaysOne) {
  llvm::IRBuilder<> &ir = code.ir;
  const Long logarithm = longLog2(code, base);
  Value *const product = ir.CreateFMul(exponent, logarithm.high);
  Value *const error = multiplyAdd(code, exponent, logarithm.high, ir.CreateFNeg(product));
  Value *const tail = multiplyAdd(code, exponent, logarithm.low, error);
  Value *const whole = ir.CreateUnaryIntrinsic(llvm::Intrinsic::rint, product);
  Value *f = ir.CreateFAdd(ir.CreateFSub(product, whole), tail);
  // An infinite or too large product has no fraction. Any value but NaN will do.
  constexpr unsigned kSmallerMagnitude = 2;
  f = range(code, f, code.splat(1.0f), kSmallerMagnitude);
  Value *const fraction =
      multiplyAdd(code, f, polynomial<float>(code, f, kExp2Centred), code.splat(1.0f));
  Value *const zero = code.splat(0.0f);
  Value *const powered =
      code.select(ir.CreateFCmpOGT(base, zero), scaled(code, fraction, whole), zero);
  return code.select(isOne(code, base, exponent, oneStaysOne), code.splat(1.0f), powered);
}

Value *reciprocalRoot(Code &code, Value *magnitude) {
  // This refines an estimate of 14 bits by one Newton step. The step fails for 0 and infinity,
  // where the estimate is exact.
  Value *const estimate = code.ir.CreateIntrinsic(
      llvm::Intrinsic::x86_avx512_rsqrt14_ps_512, {},
      {magnitude, llvm::Constant::getNullValue(code.f32), code.ir.getInt16(0xFFFF)});
  Value *const error =
      multiplyAdd(code, code.ir.CreateFNeg(code.ir.CreateFMul(magnitude, estimate)), estimate,
                  code.splat(1.0f));
  Value *const better =
      multiplyAdd(code, code.ir.CreateFMul(estimate, code.splat(0.5f)), error, estimate);
  return code.select(code.ir.CreateFCmpUNO(error, error), estimate, better);
}

} // namespace arbiter::fp::llvm_back::avx512
