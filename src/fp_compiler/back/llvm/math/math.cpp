#include "fp_compiler/back/llvm/math/math.h"

#include <limits>

#include "fp_compiler/back/llvm/math/exponent.h"
#include "fp_compiler/back/llvm/math/math_avx2.h"
#include "fp_compiler/back/llvm/math/math_avx512.h"

namespace arbiter::fp::llvm_back {

namespace {
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Minimax polynomials for the relative error (Remez exchange), lowest power first.

/// log2(1 + t) / t for 1 + t in [sqrt(1/2), sqrt(2)], within 2^-25.1.
constexpr float kLog2[] = {0x1.715476p+0f,  -0x1.715470p-1f, 0x1.ec73d6p-2f,
                           -0x1.715c4ep-2f, 0x1.26d384p-2f,  -0x1.e95be4p-3f,
                           0x1.b9c91ap-3f,  -0x1.a87d18p-3f, 0x1.01b6e8p-3f};
/// The same within 2^-33.2.
constexpr double kLog2Long[] = {
    0x1.71547652ef963p+0, -0x1.7154767baea14p-1, 0x1.ec709c00ea859p-2, -0x1.715435ebca40dp-2,
    0x1.277732d075b21p-2, -0x1.ec8d73c7629d9p-3, 0x1.a615cad3b3dfcp-3, -0x1.6eb02b88c7707p-3,
    0x1.45a2992a1a9f1p-3, -0x1.417feceec5d4ep-3, 0x1.3d25d9cacb37bp-3, -0x1.61ac19a585028p-4};
/// (sin(r)/r - 1) / r^2 and (cos(r) - 1 + r^2/2) / r^4 in r^2, for |r| up to pi/4: within 2^-28.
constexpr float kSine[] = {-0x1.555546p-3f, 0x1.11075ep-7f, -0x1.994dd6p-13f};
constexpr float kCosine[] = {0x1.55554ap-5f, -0x1.6c0c8ap-10f, 0x1.9a0194p-16f};

/// pi/2 in two parts, the first of 33 bits, so that small multiples of it are exact.
constexpr double kHalfPiHigh = 0x1.921fb544p+0;
constexpr double kHalfPiLow = 0x1.0b4611a626331p-34;
constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;

llvm::Type *doubles(Code &code) {
  return llvm::FixedVectorType::get(code.ir.getDoubleTy(), unsigned(code.lanes));
}

/// The number that all lanes of a constant have.
const llvm::APFloat *constantOf(Value *value) {
  const auto *const vector = llvm::dyn_cast<llvm::Constant>(value);
  const auto *const number =
      vector ? llvm::dyn_cast_or_null<llvm::ConstantFP>(vector->getSplatValue()) : nullptr;
  return number && !number->getValueAPF().isNaN() ? &number->getValueAPF() : nullptr;
}

Value *extremum(Code &code, Value *a, Value *b, bool larger) {
  if (constantOf(a))
    std::swap(a, b);
  if (const llvm::APFloat *const limit = constantOf(b)) {
    // Of equal zeros the result is b's unless a's is beyond it.
    const bool mayPass = limit->isZero() && limit->isNegative() == larger;
    const auto beyond = larger    ? mayPass ? llvm::CmpInst::FCMP_OGE : llvm::CmpInst::FCMP_OGT
                        : mayPass ? llvm::CmpInst::FCMP_OLE
                                  : llvm::CmpInst::FCMP_OLT;
    return code.ir.CreateSelect(code.ir.CreateFCmp(beyond, a, b), a, b);
  }
  if (code.cpu.family == Cpu::Family::Avx512)
    return avx512::extremum(code, a, b, larger);
  // Equal values have equal bits, but for zeros: of those the bits are joined.
  Value *const left = code.ir.CreateBitCast(a, code.i32);
  Value *const right = code.ir.CreateBitCast(b, code.i32);
  Value *const joined = code.ir.CreateBitCast(
      larger ? code.ir.CreateAnd(left, right) : code.ir.CreateOr(left, right), code.f32);
  Value *const beyond = larger ? code.ir.CreateFCmpOGT(a, b) : code.ir.CreateFCmpOLT(a, b);
  Value *const useA = code.ir.CreateOr(beyond, code.ir.CreateFCmpUNO(b, b));
  return code.ir.CreateSelect(useA, a,
                              code.ir.CreateSelect(code.ir.CreateFCmpOEQ(a, b), joined, b));
}
} // namespace

Value *multiplyAdd(Code &code, Value *a, Value *b, Value *c) {
  if (code.cpu.family == Cpu::Family::Sse41)
    return code.ir.CreateFAdd(code.ir.CreateFMul(a, b), c);
  return code.ir.CreateIntrinsic(llvm::Intrinsic::fma, {a->getType()}, {a, b, c});
}

Value *absolute(Code &code, Value *x) {
  return code.ir.CreateUnaryIntrinsic(llvm::Intrinsic::fabs, x);
}

Value *minimum(Code &code, Value *a, Value *b) { return extremum(code, a, b, false); }
Value *maximum(Code &code, Value *a, Value *b) { return extremum(code, a, b, true); }

Value *exp2(Code &code, Value *x) {
  if (code.cpu.family == Cpu::Family::Avx512)
    return avx512::exp2(code, x);
  Value *const inRange = clampedExponent(code, x);
  Value *const whole = code.floor(inRange);
  return assembled(code, whole, code.ir.CreateFSub(inRange, whole));
}

Value *log2(Code &code, Value *x) {
  if (code.cpu.family == Cpu::Family::Avx512)
    return avx512::log2(code, x);
  const Mantissa parts = mantissaOf(code, x);
  Value *const t = code.ir.CreateFSub(parts.value, code.splat(1.0f)); // exact
  Value *const finite =
      multiplyAdd(code, t, polynomial<float>(code, t, kLog2), code.toFloat(parts.exponent));
  Value *const positive =
      code.select(code.ir.CreateFCmpOEQ(x, code.splat(kInfinity)), code.splat(kInfinity), finite);
  Value *const other = code.select(code.ir.CreateFCmpOEQ(x, code.splat(0.0f)),
                                   code.splat(-kInfinity), code.splat(kNan));
  return code.select(code.ir.CreateFCmpOGT(x, code.splat(0.0f)), positive, other);
}

Value *power(Code &code, Value *base, Value *exponent, bool oneStaysOne) {
  if (code.cpu.family == Cpu::Family::Avx512)
    return avx512::power(code, base, exponent, oneStaysOne);
  if (code.cpu.family == Cpu::Family::Avx2)
    return avx2::power(code, base, exponent, oneStaysOne);
  // The product of a logarithm and an exponent may be as large as 128, so that a single's last
  // bits would be lost in it: doubles up to the fraction.
  llvm::Type *const wide = doubles(code);
  const Mantissa parts = mantissaOf(code, base);
  Value *const longT = code.ir.CreateFPExt(code.ir.CreateFSub(parts.value, code.splat(1.0f)), wide);
  Value *const finite = multiplyAdd(code, longT, polynomial<double>(code, longT, kLog2Long),
                                    code.ir.CreateSIToFP(parts.exponent, wide));
  Value *const infinite = code.ir.CreateFCmpOEQ(base, code.splat(kInfinity));
  Value *const logarithm =
      code.ir.CreateSelect(infinite, llvm::ConstantFP::get(wide, double(kInfinity)), finite);
  Value *const product = code.ir.CreateFMul(code.ir.CreateFPExt(exponent, wide), logarithm);
  Value *const inRange = clampedExponent(code, product);
  Value *const floor = code.floor(inRange);
  Value *const result =
      assembled(code, code.ir.CreateFPTrunc(floor, code.f32),
                code.ir.CreateFPTrunc(code.ir.CreateFSub(inRange, floor), code.f32));
  Value *const zero = code.splat(0.0f);
  Value *const powered = code.select(code.ir.CreateFCmpOGT(base, zero), result, zero);
  return code.select(isOne(code, base, exponent, oneStaysOne), code.splat(1.0f), powered);
}

SineCosine sineCosine(Code &code, Value *angle) {
  Value *const x = code.ir.CreateFPExt(angle, doubles(code));
  Value *const turns = code.ir.CreateUnaryIntrinsic(
      llvm::Intrinsic::rint, code.ir.CreateFMul(x, constantLike(x, kTwoOverPi)));
  Value *rest = multiplyAdd(code, turns, constantLike(x, -kHalfPiHigh), x);
  rest = multiplyAdd(code, turns, constantLike(x, -kHalfPiLow), rest);
  // Of an angle too large for this the rest is anything: it is held where the polynomials are.
  Value *r = code.ir.CreateFPTrunc(rest, code.f32);
  Value *const low = code.splat(-0.7854f), *const high = code.splat(0.7854f);
  r = code.select(code.ir.CreateFCmpOGT(low, r), low, r);
  r = code.select(code.ir.CreateFCmpOLT(high, r), high, r);
  // The quadrant, of a number that may be beyond 32 bits.
  Value *const fours = code.floor(code.ir.CreateFMul(turns, constantLike(x, 0.25)));
  Value *const quadrant = code.ir.CreateFreeze(code.ir.CreateFPToSI(
      code.ir.CreateFSub(turns, code.ir.CreateFMul(fours, constantLike(x, 4.0))), code.i32));

  Value *const square = code.ir.CreateFMul(r, r);
  Value *const sine =
      multiplyAdd(code, code.ir.CreateFMul(r, square), polynomial<float>(code, square, kSine), r);
  Value *const cosine = multiplyAdd(code, code.ir.CreateFMul(square, square),
                                    polynomial<float>(code, square, kCosine),
                                    multiplyAdd(code, square, code.splat(-0.5f), code.splat(1.0f)));
  Value *const odd =
      code.ir.CreateICmpNE(code.ir.CreateAnd(quadrant, code.splat(1)), code.splat(0));
  const auto negatedWhere = [&](Value *value, Value *bits) {
    Value *const sign = code.ir.CreateShl(code.ir.CreateAnd(bits, code.splat(2)), code.splat(30));
    return code.ir.CreateBitCast(code.ir.CreateXor(code.ir.CreateBitCast(value, code.i32), sign),
                                 code.f32);
  };
  SineCosine result;
  result.sine = negatedWhere(code.select(odd, cosine, sine), quadrant);
  // The sum that makes the rest loses the sign of a zero.
  result.sine = code.select(code.ir.CreateFCmpOEQ(angle, code.splat(0.0f)), angle, result.sine);
  result.cosine =
      negatedWhere(code.select(odd, sine, cosine), code.ir.CreateAdd(quadrant, code.splat(1)));
  return result;
}

Value *reciprocal(Code &code, Value *x) { return code.ir.CreateFDiv(code.splat(1.0f), x); }

Value *reciprocalRoot(Code &code, Value *x) {
  Value *const magnitude = absolute(code, x);
  if (code.cpu.family == Cpu::Family::Avx512)
    return avx512::reciprocalRoot(code, magnitude);
  if (code.cpu.family == Cpu::Family::Avx2)
    return avx2::reciprocalRoot(code, magnitude);
  return reciprocal(code, code.ir.CreateUnaryIntrinsic(llvm::Intrinsic::sqrt, magnitude));
}

} // namespace arbiter::fp::llvm_back
