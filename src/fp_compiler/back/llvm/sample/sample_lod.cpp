#include "fp_compiler/back/llvm/code/quads.h"
#include "fp_compiler/back/llvm/math/math.h"
#include "fp_compiler/back/llvm/sample/sample_parts.h"

#include <llvm/IR/Intrinsics.h>

/// Computes levels of detail from derivatives (3.8.8).
namespace arbiter::fp::llvm_back {

namespace {

/// MAX_TEXTURE_LOD_BIAS, to which the sum of all biases is clamped.
constexpr float kMaxBias = 16;

/// Returns the square of the scale factor. It is the longer change for one pixel in x or in y, in
/// texels of the base level.
Value *scaleSquared(Code &code, const abi::SamplerKey &key, Value *view, const Derivatives &d,
                    const CubeFace *cube) {
  const auto [x, y] = inTexels(code, key, view, d, cube);
  return code.max(dot(code, x, x), dot(code, y, y));
}

Value *viewField(Code &code, Value *view, std::size_t offset) {
  return code.splat(constantField(code, code.ir.getFloatTy(), view, offset));
}

/// Clamps a level to [0, levelCount) and returns it as i32. NaN gives 0.
/// \param level a whole number
Value *clampedLevel(Code &code, Value *view, Value *level) {
  Value *const count =
      constantField(code, code.ir.getInt32Ty(), view, offsetof(abi::TextureView, levelCount));
  Value *const last = code.ir.CreateSub(count, code.ir.getInt32(1));
  Value *const high = code.splat(code.ir.CreateSIToFP(last, code.ir.getFloatTy()));
  return code.toInt(code.min(code.max(level, code.splat(0.0f)), high));
}

} // namespace

Derivatives derivativesOf(Code &code, const abi::SamplerKey &key, abi::Lanes lanes,
                          const SampleAt &at) {
  if (lanes == abi::Lanes::Row || at.dx[0])
    return {at.dx, at.dy};
  SampleAt quads = at;
  if (key.dimension == abi::Dimension::Cube)
    addPixelDerivatives(code, quads, 3);
  else
    addQuadDerivatives(code, quads, dimensionsOf(key.dimension), nullptr);
  return {quads.dx, quads.dy};
}

std::array<Vec, 2> inTexels(Code &code, const abi::SamplerKey &key, Value *view,
                            const Derivatives &d, const CubeFace *cube) {
  const int dimensions = dimensionsOf(key.dimension);
  const ImageCode base = loadImage(code, key.format, view, code.ir.getInt32(0), dimensions);
  const auto texels = [&](const std::array<Value *, 3> &change) {
    Vec moved = cube ? cube->derivative(change) : Vec{change[0], change[1], change[2]};
    moved.back() = nullptr;
    for (std::size_t i = 0; i < 3; ++i) {
      if (int(i) >= dimensions) {
        moved[i] = nullptr;
      } else if (key.dimension != abi::Dimension::Rect) {
        Value *const size = code.ir.CreateSIToFP(base.size[i], code.ir.getFloatTy());
        moved[i] = code.ir.CreateFMul(moved[i], code.splat(size));
      }
    }
    return moved;
  };
  return {texels(d.dx), texels(d.dy)};
}

Value *dot(Code &code, const Vec &a, const Vec &b) {
  Value *sum = code.ir.CreateFMul(a[0], b[0]);
  for (std::size_t i = 1; i < 3 && a[i]; ++i)
    sum = multiplyAdd(code, a[i], b[i], sum);
  return sum;
}

namespace {
/// Exponent and mantissa in [1, 2) of a number that is not negative, as floats.
struct ExponentAndMantissa {
  Value *exponent, *mantissa;
};
ExponentAndMantissa takeApart(Code &code, Value *x) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *const bits = ir.CreateBitCast(x, code.i32);
  Value *const mantissa =
      ir.CreateOr(ir.CreateAnd(bits, code.splat(0x7FFFFF)), code.splat(0x3F800000));
  return {code.toFloat(ir.CreateSub(ir.CreateLShr(bits, code.splat(23)), code.splat(127))),
          ir.CreateBitCast(mantissa, code.f32)};
}
} // namespace

Value *linearLog2(Code &code, Value *x) {
  const ExponentAndMantissa parts = takeApart(code, x);
  return code.ir.CreateFAdd(code.ir.CreateFSub(parts.mantissa, code.splat(1.0f)), parts.exponent);
}

Value *quickLog2(Code &code, Value *x) {
  const ExponentAndMantissa parts = takeApart(code, x);
  Value *const t = code.ir.CreateFSub(parts.mantissa, code.splat(1.0f));
  // The coefficients are of log2(1 + t) / t, interpolated at Chebyshev nodes and exactly 1 at t =
  // 1.
  constexpr float kCoefficients[] = {0.0448739553f, -0.195407152f, 0.420111212f, -0.711996593f,
                                     1.44241858f};
  Value *sum = code.splat(kCoefficients[0]);
  for (std::size_t i = 1; i < std::size(kCoefficients); ++i)
    sum = multiplyAdd(code, sum, t, code.splat(kCoefficients[i]));
  return multiplyAdd(code, sum, t, parts.exponent);
}

Value *biasedLevel(Code &code, const abi::SamplerKey &key, Value *view, const SampleAt &at,
                   Value *lambda) {
  Value *bias = key.dimension == abi::Dimension::Rect ? nullptr : at.bias;
  if (key.hasBias) {
    Value *const fixed = viewField(code, view, offsetof(abi::TextureView, lodBias));
    bias = bias ? code.ir.CreateFAdd(bias, fixed) : fixed;
  }
  if (bias)
    lambda = code.ir.CreateFAdd(
        lambda, code.min(code.max(bias, code.splat(-kMaxBias)), code.splat(kMaxBias)));
  if (key.hasBias)
    lambda = code.min(code.max(lambda, viewField(code, view, offsetof(abi::TextureView, minLod))),
                      viewField(code, view, offsetof(abi::TextureView, maxLod)));
  return lambda;
}

Value *levelOfDetail(Code &code, const abi::SamplerKey &key, abi::Lanes lanes, Value *view,
                     const SampleAt &at, const CubeFace *cube) {
  if (at.lod)
    return biasedLevel(code, key, view, at, at.lod);
  const Derivatives d = derivativesOf(code, key, lanes, at);
  Value *lambda = code.splat(0.0f);
  if (d.dx[0])
    lambda = code.ir.CreateFMul(linearLog2(code, scaleSquared(code, key, view, d, cube)),
                                code.splat(0.5f));
  return biasedLevel(code, key, view, at, lambda);
}

LevelChoice chooseLevels(Code &code, const abi::SamplerKey &key, Value *view, Value *lambda) {
  LevelChoice choice;
  if (key.mip == abi::MipFilter::Nearest) {
    // The level is ceil(lambda + 1/2) - 1.
    Value *const up = code.ir.CreateUnaryIntrinsic(llvm::Intrinsic::ceil,
                                                   code.ir.CreateFSub(lambda, code.splat(0.5f)));
    choice.first = clampedLevel(code, view, up);
    return choice;
  }
  Value *const whole = code.floor(lambda);
  choice.first = clampedLevel(code, view, whole);
  choice.second = clampedLevel(code, view, code.ir.CreateFAdd(whole, code.splat(1.0f)));
  // If both levels are the same the weight does not matter, but 0 avoids reading it again.
  choice.fraction = code.select(code.ir.CreateICmpEQ(choice.first, choice.second), code.splat(0.0f),
                                code.ir.CreateFSub(lambda, whole));
  return choice;
}

} // namespace arbiter::fp::llvm_back
