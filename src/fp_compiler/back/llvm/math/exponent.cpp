#include "fp_compiler/back/llvm/math/exponent.h"

namespace arbiter::fp::llvm_back {

namespace {
/// Coefficients of (2^f - 1) / f for f in [0, 1], minimax for the relative error (Remez exchange),
/// lowest power first. 1 + f * p is within 2^-28.8 of 2^f.
constexpr float kExp2[] = {0x1.62e42cp-1f, 0x1.ebfd58p-3f,  0x1.c68912p-5f,
                           0x1.3d0b92p-7f, 0x1.46d64ep-10f, 0x1.c54170p-13f};
/// Coefficients of llvmpipe's approximation of 2^f, within 2^-21.8.
constexpr float kHostExp2[] = {1.0f,           0x1.62e4f6p-1f, 0x1.ebd5a8p-3f,
                               0x1.c95446p-5f, 0x1.26900cp-7f, 0x1.ec320ap-10f};
constexpr int kMantissaBits = 23, kBias = 127;
} // namespace

Mantissa mantissaOf(Code &code, Value *x) {
  Value *const bits = code.ir.CreateBitCast(x, code.i32);
  constexpr int kRootOfHalf = 0x3F3504F3;
  Mantissa result = {};
  result.offset = code.ir.CreateSub(bits, code.splat(kRootOfHalf));
  result.exponent = code.ir.CreateAShr(result.offset, code.splat(kMantissaBits));
  result.value = code.ir.CreateBitCast(
      code.ir.CreateSub(bits, code.ir.CreateShl(result.exponent, code.splat(kMantissaBits))),
      code.f32);
  return result;
}

Value *exp2OfFraction(Code &code, Value *f) { return evenAndOdd(code, f, kHostExp2); }

Value *scaledByBits(Code &code, Value *mantissa, Value *whole) {
  // Below the normal numbers the exponent bits give zero, above them infinity.
  Value *const biased = code.ir.CreateAdd(code.toInt(whole), code.splat(kBias));
  return code.ir.CreateFMul(
      mantissa,
      code.ir.CreateBitCast(code.ir.CreateShl(biased, code.splat(kMantissaBits)), code.f32));
}

Value *assembled(Code &code, Value *whole, Value *f) {
  return scaledByBits(
      code, multiplyAdd(code, f, polynomial<float>(code, f, kExp2), code.splat(1.0f)), whole);
}

Value *clampedExponent(Code &code, Value *x) {
  Value *const low = constantLike(x, -127.0), *const high = constantLike(x, 128.0);
  Value *const above = code.ir.CreateSelect(code.ir.CreateFCmpOGT(low, x), low, x);
  return code.ir.CreateSelect(code.ir.CreateFCmpOLT(high, above), high, above);
}

} // namespace arbiter::fp::llvm_back
