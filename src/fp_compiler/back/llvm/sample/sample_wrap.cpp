#include "fp_compiler/back/llvm/math/math.h"
#include "fp_compiler/back/llvm/sample/sample_parts.h"

#include <llvm/IR/IntrinsicsX86.h>

namespace arbiter::fp::llvm_back {
namespace {

using abi::Wrap;

constexpr unsigned kCurrentMode = 4; ///< AVX-512 operand: rounding mode of MXCSR

Value *clamp(Code &code, Value *value, Value *low, Value *high) {
  return code.min(code.max(value, low), high); // max first, so that NaN becomes `low`
}

/// Maps a coordinate to [0,1], rising and falling (MIRRORED_REPEAT). For an infinite coordinate, or
/// one too large to have a fraction, the result may be any value or NaN.
Value *mirror(Code &code, Value *coordinate) {
  // This is the distance to the nearest even number.
  Value *const half = code.ir.CreateFMul(coordinate, code.splat(0.5f));
  Value *const nearest = code.floor(code.ir.CreateFAdd(half, code.splat(0.5f)));
  return absolute(code,
                  code.ir.CreateFSub(coordinate, code.ir.CreateFMul(nearest, code.splat(2.0f))));
}

/// Applies the repeating or mirroring part of a wrap mode. Its clamping part follows.
Value *folded(Code &code, Wrap wrap, Value *coordinate) {
  switch (wrap) {
  case Wrap::Repeat:
    return code.ir.CreateFSub(coordinate, code.floor(coordinate));
  case Wrap::MirroredRepeat:
    return mirror(code, coordinate);
  case Wrap::MirrorClamp:
  case Wrap::MirrorClampToEdge:
  case Wrap::MirrorClampToBorder:
    return absolute(code, coordinate);
  case Wrap::Clamp:
  case Wrap::ClampToEdge:
  case Wrap::ClampToBorder:
    return coordinate;
  }
  llvm_unreachable("a wrap mode");
}

/// Clamps an index to [0, size), and records the lanes in which it was outside.
void bound(Code &code, Value *size, AxisTexels &axis, int which) {
  Value *const index = axis.index[std::size_t(which)];
  Value *const last = code.splat(code.ir.CreateSub(size, code.ir.getInt32(1)));
  axis.outside[std::size_t(which)] = code.ir.CreateICmpUGT(index, last);
  Value *const notNegative =
      code.ir.CreateBinaryIntrinsic(llvm::Intrinsic::smax, index, code.splat(0));
  axis.index[std::size_t(which)] =
      code.ir.CreateBinaryIntrinsic(llvm::Intrinsic::smin, notNegative, last);
}

struct Size {
  Value *scalar; ///< i32
  Value *real;   ///< f32 vector
  Value *last;   ///< f32 vector: size - 1
};
Size sizeOf(Code &code, Value *size) {
  Value *const real = code.ir.CreateSIToFP(size, code.ir.getFloatTy());
  Value *const last = code.ir.CreateFSub(real, llvm::ConstantFP::get(code.ir.getFloatTy(), 1.0));
  return {size, code.splat(real), code.splat(last)};
}

Value *inTexels(Code &code, const AxisKey &key, Value *coordinate, const Size &size) {
  return key.normalized ? code.ir.CreateFMul(coordinate, size.real) : coordinate;
}

Value *mask(Code &code, const Size &size) {
  return code.splat(code.ir.CreateSub(size.scalar, code.ir.getInt32(1)));
}

/// Rounds to the nearest integer, ties to even. Out of range gives any value.
Value *roundToInt(Code &code, Value *a) {
  llvm::IRBuilder<> &ir = code.ir;
  switch (code.cpu.family) {
  case Cpu::Family::Avx512:
    return ir.CreateIntrinsic(llvm::Intrinsic::x86_avx512_mask_cvtps2dq_512, {},
                              {a, code.splat(0), ir.getInt16(0xFFFF), ir.getInt32(kCurrentMode)});
  case Cpu::Family::Avx2:
    return ir.CreateIntrinsic(llvm::Intrinsic::x86_avx_cvt_ps2dq_256, {}, {a});
  case Cpu::Family::Sse41:
    return ir.CreateIntrinsic(llvm::Intrinsic::x86_sse2_cvtps2dq, {}, {a});
  case Cpu::Family::Neon:
    break;
  }
  return code.toInt(ir.CreateUnaryIntrinsic(llvm::Intrinsic::nearbyint, a));
}

} // namespace

bool reachesBorder(Wrap wrap, bool linear) {
  switch (wrap) {
  case Wrap::ClampToBorder:
  case Wrap::MirrorClampToBorder:
    return true;
  case Wrap::Clamp:
  case Wrap::MirrorClamp:
    return linear;
  case Wrap::Repeat:
  case Wrap::MirroredRepeat:
  case Wrap::ClampToEdge:
  case Wrap::MirrorClampToEdge:
    return false;
  }
  llvm_unreachable("a wrap mode");
}

AxisTexels nearestTexel(Code &code, const AxisKey &key, Value *coordinate, Value *sizeValue) {
  const Size size = sizeOf(code, sizeValue);
  AxisTexels axis;
  if (key.wrap == Wrap::Repeat && key.powerOfTwo && key.normalized) {
    // The mask keeps any number in range, also that of a coordinate which does not fit an integer.
    Value *const texel = code.toInt(code.floor(inTexels(code, key, coordinate, size)));
    axis.index[0] = code.ir.CreateAnd(texel, mask(code, size));
    return axis;
  }
  Value *const texel = inTexels(code, key, folded(code, key.wrap, coordinate), size);
  if (reachesBorder(key.wrap, false)) {
    Value *const near = clamp(code, texel, code.splat(-1.0f), size.real);
    axis.index[0] = code.toInt(code.floor(near));
    bound(code, size.scalar, axis, 0);
    return axis;
  }
  axis.index[0] = code.toInt(clamp(code, texel, code.splat(0.0f), size.last));
  return axis;
}

AxisTexels linearTexels(Code &code, const AxisKey &key, Value *coordinate, Value *sizeValue) {
  const Size size = sizeOf(code, sizeValue);
  AxisTexels axis;
  Value *const half = code.splat(0.5f);
  if (key.wrap == Wrap::Repeat && key.powerOfTwo && key.normalized) {
    Value *const texel = code.ir.CreateFSub(inTexels(code, key, coordinate, size), half);
    Value *const whole = code.floor(texel);
    axis.fraction = code.ir.CreateFSub(texel, whole);
    Value *const first = code.toInt(whole);
    axis.index[0] = code.ir.CreateAnd(first, mask(code, size));
    axis.index[1] = code.ir.CreateAnd(code.ir.CreateAdd(first, code.splat(1)), mask(code, size));
    axis.next = AxisTexels::Next::Repeat;
    return axis;
  }
  Value *texel = inTexels(code, key, folded(code, key.wrap, coordinate), size);
  if (key.wrap == Wrap::Repeat) {
    texel = code.ir.CreateFSub(clamp(code, texel, code.splat(0.0f), size.real), half);
    Value *const whole = code.floor(texel);
    axis.fraction = code.ir.CreateFSub(texel, whole);
    Value *const first = code.toInt(whole); // -1 to size - 1
    Value *const last = mask(code, size);
    Value *const zero = code.splat(0);
    axis.index[0] = code.select(code.ir.CreateICmpSLT(first, zero), last, first);
    axis.index[1] = code.select(code.ir.CreateICmpEQ(first, last), zero,
                                code.ir.CreateAdd(first, code.splat(1)));
    axis.next = AxisTexels::Next::Repeat;
    return axis;
  }
  if (reachesBorder(key.wrap, true)) {
    const bool half01 = key.wrap == Wrap::Clamp || key.wrap == Wrap::MirrorClamp;
    Value *const low = half01 ? code.splat(0.0f) : code.ir.CreateFNeg(half);
    Value *const high = half01 ? size.real : code.ir.CreateFAdd(size.real, half);
    texel = code.ir.CreateFSub(clamp(code, texel, low, high), half);
    Value *const whole = code.floor(texel);
    axis.fraction = code.ir.CreateFSub(texel, whole);
    axis.index[0] = code.toInt(whole);
    axis.index[1] = code.ir.CreateAdd(axis.index[0], code.splat(1));
    bound(code, size.scalar, axis, 0);
    bound(code, size.scalar, axis, 1);
    return axis;
  }
  texel = clamp(code, code.ir.CreateFSub(texel, half), code.splat(0.0f), size.last);
  axis.index[0] = code.toInt(texel);
  axis.fraction = code.ir.CreateFSub(texel, code.toFloat(axis.index[0]));
  // At the last texel the fraction is 0, so its neighbour has no weight.
  axis.index[1] = code.ir.CreateBinaryIntrinsic(
      llvm::Intrinsic::smin, code.ir.CreateAdd(axis.index[0], code.splat(1)), mask(code, size));
  axis.next = AxisTexels::Next::Edge;
  return axis;
}

/// Returns the texels of a repeating wrap mode for a coordinate in 256ths of a texel.
/// \param folded true if the coordinate was reduced to [0,1] or NaN
static AxisTexels repeatedBytes(Code &code, Value *fixed, Value *last, bool folded) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *first = ir.CreateAShr(fixed, code.splat(kWeightBits));
  Value *second = nullptr;
  if (folded) {
    first = code.select(ir.CreateICmpSLT(first, code.splat(0)), last, first);
    first = ir.CreateBinaryIntrinsic(llvm::Intrinsic::smin, first, last);
    second = code.select(ir.CreateICmpEQ(first, last), code.splat(0),
                         ir.CreateAdd(first, code.splat(1)));
  } else {
    first = ir.CreateAnd(first, last);
    second = ir.CreateAnd(ir.CreateAdd(first, code.splat(1)), last);
  }
  AxisTexels axis;
  axis.index = {first, second};
  axis.next = AxisTexels::Next::Repeat;
  axis.weight = ir.CreateAnd(fixed, code.splat((1 << kWeightBits) - 1));
  return axis;
}

/// Returns the texels of a clamping wrap mode. Beyond either end it is the last texel, without
/// weight.
static AxisTexels clampedBytes(Code &code, Value *fixed, Value *last) {
  llvm::IRBuilder<> &ir = code.ir;
  fixed = ir.CreateBinaryIntrinsic(llvm::Intrinsic::smax, fixed, code.splat(0));
  fixed = ir.CreateBinaryIntrinsic(llvm::Intrinsic::smin, fixed,
                                   ir.CreateShl(last, code.splat(kWeightBits)));
  AxisTexels axis;
  axis.index[0] = ir.CreateAShr(fixed, code.splat(kWeightBits));
  axis.index[1] = ir.CreateBinaryIntrinsic(llvm::Intrinsic::smin,
                                           ir.CreateAdd(axis.index[0], code.splat(1)), last);
  axis.next = AxisTexels::Next::Edge;
  axis.weight = ir.CreateAnd(fixed, code.splat((1 << kWeightBits) - 1));
  return axis;
}

AxisTexels linearTexelsOfBytes(Code &code, const AxisKey &key, Value *coordinate,
                               Value *sizeValue) {
  llvm::IRBuilder<> &ir = code.ir;
  const Size size = sizeOf(code, sizeValue);
  const bool folds = key.wrap == Wrap::Repeat && !(key.powerOfTwo && key.normalized);
  if (folds)
    coordinate = folded(code, key.wrap, coordinate);
  // A coordinate that does not fit an integer gives some valid texel.
  Value *const scale = code.splat(float(1 << kWeightBits));
  Value *const scaled = key.normalized ? ir.CreateFMul(coordinate, ir.CreateFMul(size.real, scale))
                                       : ir.CreateFMul(coordinate, scale);
  Value *const fixed = ir.CreateSub(roundToInt(code, scaled), code.splat(1 << (kWeightBits - 1)));
  Value *const last = mask(code, size);
  return key.wrap == Wrap::Repeat ? repeatedBytes(code, fixed, last, folds)
                                  : clampedBytes(code, fixed, last);
}

} // namespace arbiter::fp::llvm_back
