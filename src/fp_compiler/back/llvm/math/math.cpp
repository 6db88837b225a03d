#include "fp_compiler/back/llvm/math/math.h"

#include <limits>
#include <span>

#include "fp_compiler/back/llvm/math/exponent.h"
#include "fp_compiler/back/llvm/math/math_avx2.h"
#include "fp_compiler/back/llvm/math/math_avx512.h"

namespace arbiter::fp::llvm_back {

namespace {
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// The polynomials are minimax for the relative error (Remez exchange), lowest power first.

/// Coefficients of log2(1 + t) / t for 1 + t in [sqrt(1/2), sqrt(2)], within 2^-25.1.
constexpr float kLog2[] = {0x1.715476p+0f,  -0x1.715470p-1f, 0x1.ec73d6p-2f,
                           -0x1.715c4ep-2f, 0x1.26d384p-2f,  -0x1.e95be4p-3f,
                           0x1.b9c91ap-3f,  -0x1.a87d18p-3f, 0x1.01b6e8p-3f};
/// Coefficients of log2(1 + t) / t on the same range, within 2^-33.2.
constexpr double kLog2Long[] = {
    0x1.71547652ef963p+0, -0x1.7154767baea14p-1, 0x1.ec709c00ea859p-2, -0x1.715435ebca40dp-2,
    0x1.277732d075b21p-2, -0x1.ec8d73c7629d9p-3, 0x1.a615cad3b3dfcp-3, -0x1.6eb02b88c7707p-3,
    0x1.45a2992a1a9f1p-3, -0x1.417feceec5d4ep-3, 0x1.3d25d9cacb37bp-3, -0x1.61ac19a585028p-4};
/// llvmpipe's coefficients of (sin(r)/r - 1) / r^2 and (cos(r) - 1 + r^2/2) / r^4 in r^2, for |r|
/// up to pi/4.
constexpr float kSine[] = {-0x1.555546p-3f, 0x1.11073cp-7f, -0x1.9943f2p-13f};
constexpr float kCosine[] = {0x1.55554ap-5f, -0x1.6c0c34p-10f, 0x1.99eb9cp-16f};

/// pi/4 as three parts with few bits, so that small multiples of the first two are exact.
constexpr float kQuarterPi[] = {0x1.92p-1f, 0x1.fb4p-13f, 0x1.4442d2p-25f};
constexpr float kFourOverPi = 0x1.45f306p+0f;

llvm::Type *doubles(Code &code) {
  return llvm::FixedVectorType::get(code.ir.getDoubleTy(), unsigned(code.lanes));
}

/// Returns the number in all lanes of a constant, or null.
const llvm::APFloat *constantOf(Value *value) {
  const auto *const vector = llvm::dyn_cast<llvm::Constant>(value);
  const auto *const number =
      vector ? llvm::dyn_cast_or_null<llvm::ConstantFP>(vector->getSplatValue()) : nullptr;
  return number && !number->getValueAPF().isNaN() ? &number->getValueAPF() : nullptr;
}

constexpr int kSignBit = std::numeric_limits<int>::min();

/// Evaluates a polynomial by Horner's rule.
Value *byHorner(Code &code, Value *x, std::span<const float> coefficients) {
  Value *sum = code.splat(coefficients.back());
  for (std::size_t i = coefficients.size() - 1; i-- > 0;)
    sum = multiplyAdd(code, sum, x, code.splat(coefficients[i]));
  return sum;
}

/// Returns \p size - quarters * pi/4. With fused multiply-adds, the products are exact up to 2^22
/// quarters. Otherwise one product in doubles is exact enough.
Value *restOfQuarters(Code &code, Value *size, Value *quarters) {
  if (code.cpu.family == Cpu::Family::Sse41) {
    Value *const count = code.ir.CreateSIToFP(quarters, doubles(code));
    const double quarter = double(kQuarterPi[0]) + double(kQuarterPi[1]) + double(kQuarterPi[2]);
    Value *const rest = multiplyAdd(code, count, constantLike(count, -quarter),
                                    code.ir.CreateFPExt(size, doubles(code)));
    return code.ir.CreateFPTrunc(rest, code.f32);
  }
  Value *const count = code.toFloat(quarters);
  for (const float part : kQuarterPi)
    size = multiplyAdd(code, count, code.splat(-part), size);
  return size;
}

/// Returns a sine or cosine clamped to [-1, 1]. For huge angles the polynomials give any value, and
/// NaN becomes 1. Infinite and NaN angles give NaN.
Value *clampedUnit(Code &code, Value *x, Value *size) {
  Value *const low = code.splat(-1.0f), *const high = code.splat(1.0f);
  Value *const below = code.select(code.ir.CreateFCmpOLT(x, high), x, high);
  Value *const unit = code.select(code.ir.CreateFCmpOGT(below, low), below, low);
  Value *const isFinite = code.ir.CreateFCmpOLT(size, code.splat(kInfinity));
  return code.select(isFinite, unit, code.splat(kNan));
}

Value *extremum(Code &code, Value *a, Value *b, bool larger) {
  if (constantOf(a))
    std::swap(a, b);
  if (const llvm::APFloat *const limit = constantOf(b)) {
    // If both are zeros, the result is b unless the sign of a decides for a.
    const bool mayPass = limit->isZero() && limit->isNegative() == larger;
    const auto beyond = larger    ? mayPass ? llvm::CmpInst::FCMP_OGE : llvm::CmpInst::FCMP_OGT
                        : mayPass ? llvm::CmpInst::FCMP_OLE
                                  : llvm::CmpInst::FCMP_OLT;
    return code.ir.CreateSelect(code.ir.CreateFCmp(beyond, a, b), a, b);
  }
  if (code.cpu.family == Cpu::Family::Avx512)
    return avx512::extremum(code, a, b, larger);
  // Equal values have equal bits, except for zeros. Joining the bits gives the right zero.
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
  return scaledByBits(code, exp2OfFraction(code, code.ir.CreateFSub(inRange, whole)), whole);
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
  // The product of a logarithm and an exponent may be as large as 128 and would lose the last bits
  // of a single float. It is therefore computed in doubles up to the fraction.
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
  llvm::IRBuilder<> &ir = code.ir;
  Value *const size = absolute(code, angle);
  // This is the nearest even number of quarters of pi. It is undefined for angles beyond 32 bits.
  Value *const whole = code.toInt(ir.CreateFMul(size, code.splat(kFourOverPi)));
  Value *const quarters = ir.CreateAnd(ir.CreateAdd(whole, code.splat(1)), code.splat(~1));
  Value *const r = restOfQuarters(code, size, quarters);

  Value *const square = ir.CreateFMul(r, r);
  Value *const sine = multiplyAdd(code, ir.CreateFMul(byHorner(code, square, kSine), square), r, r);
  Value *const tail = ir.CreateFMul(ir.CreateFMul(byHorner(code, square, kCosine), square), square);
  Value *const cosine =
      ir.CreateFAdd(ir.CreateFSub(tail, ir.CreateFMul(square, code.splat(0.5f))), code.splat(1.0f));

  Value *const odd = ir.CreateICmpNE(ir.CreateAnd(quarters, code.splat(2)), code.splat(0));
  // Bit 2 of the quarters is the sign for a positive angle. A sine also takes the angle's own sign.
  const auto negatedWhere = [&](Value *value, Value *bits) {
    Value *const sign = ir.CreateAnd(bits, code.splat(kSignBit));
    Value *const signedValue = ir.CreateXor(ir.CreateBitCast(value, code.i32), sign);
    return clampedUnit(code, ir.CreateBitCast(signedValue, code.f32), size);
  };
  const auto halfTurns = [&](Value *count) { return ir.CreateShl(count, code.splat(29)); };
  SineCosine result;
  result.sine = negatedWhere(code.select(odd, cosine, sine),
                             ir.CreateXor(ir.CreateBitCast(angle, code.i32), halfTurns(quarters)));
  result.cosine = negatedWhere(code.select(odd, sine, cosine),
                               halfTurns(ir.CreateAdd(quarters, code.splat(2))));
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
