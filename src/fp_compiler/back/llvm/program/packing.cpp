#include "fp_compiler/back/llvm/program/packing.h"

#include <llvm/IR/Intrinsics.h>

#include "fp_compiler/back/llvm/math/math.h"

namespace arbiter::fp::llvm_back {

using ir::Packing;

namespace {
/// Clamps a number and scales it to an integer, as i32; NaN counts as the least value.
Value *scaled(Code &code, Value *value, float least, float scale, float offset) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *const clamped = code.min(code.max(value, code.splat(least)), code.splat(1.0f));
  Value *const exact = ir.CreateFAdd(ir.CreateFMul(code.splat(scale), clamped), code.splat(offset));
  return code.toInt(ir.CreateUnaryIntrinsic(llvm::Intrinsic::nearbyint, exact));
}

/// Returns the bits of a half float, rounded to nearest, ties to even.
Value *halfOf(Code &code, Value *value) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *const bits = ir.CreateBitCast(value, code.i32);
  Value *const sign = ir.CreateAnd(ir.CreateLShr(bits, code.splat(16)), code.splat(0x8000));
  Value *const size = ir.CreateAnd(bits, code.splat(0x7FFFFFFF));
  const auto below = [&](int bound) { return ir.CreateICmpSLT(size, code.splat(bound)); };
  Value *const odd = ir.CreateAnd(ir.CreateLShr(size, code.splat(13)), code.splat(1));
  Value *const near = ir.CreateAdd(ir.CreateAdd(size, code.splat(0xFFF)), odd);
  Value *half = ir.CreateLShr(ir.CreateSub(near, code.splat(0x38000000)), code.splat(13));
  // Below 2^-14 the unit of a half is 2^-24, as is that of floats from 1/2 on. Adding 1/2 therefore
  // rounds.
  Value *const moved = ir.CreateFAdd(absolute(code, value), code.splat(0.5f));
  Value *const units = ir.CreateSub(ir.CreateBitCast(moved, code.i32), code.splat(0x3F000000));
  half = code.select(below(0x38800000), units, half);
  half = code.select(below(0x477FF000), half, code.splat(0x7C00)); // 65520
  half = ir.CreateOr(half, sign);
  return code.select(below(0x7F800001), half, code.splat(0x7FFF));
}

/// Returns the value of a half float in the low bits of an i32. All other bits must be 0.
Value *floatOf(Code &code, Value *half) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *const size = ir.CreateAnd(half, code.splat(0x7FFF));
  Value *const sign = ir.CreateShl(ir.CreateAnd(half, code.splat(0x8000)), code.splat(16));
  Value *const shifted = ir.CreateShl(size, code.splat(13));
  Value *const usual = ir.CreateAdd(shifted, code.splat(0x38000000));
  Value *const special = ir.CreateOr(shifted, code.splat(0x7F800000));
  Value *const small =
      ir.CreateBitCast(ir.CreateFMul(code.toFloat(size), code.splat(0x1p-24f)), code.i32);
  Value *magnitude = code.select(ir.CreateICmpSLT(size, code.splat(0x7C00)), usual, special);
  magnitude = code.select(ir.CreateICmpSLT(size, code.splat(0x400)), small, magnitude);
  return ir.CreateBitCast(ir.CreateOr(magnitude, sign), code.f32);
}

/// Joins integers to the bits of a float, the first one lowest.
Value *joined(Code &code, llvm::ArrayRef<Value *> parts, int bits) {
  Value *all = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i)
    all = code.ir.CreateOr(all, code.ir.CreateShl(parts[i], code.splat(int(i) * bits)));
  return code.ir.CreateBitCast(all, code.f32);
}

/// Extracts one of the joined integers, as an i32.
Value *part(Code &code, Value *value, int index, int bits) {
  Value *const all = code.ir.CreateBitCast(value, code.i32);
  Value *const low = code.ir.CreateLShr(all, code.splat(index * bits));
  return code.ir.CreateAnd(low, code.splat((1 << bits) - 1));
}

/// Returns a component of a packed value.
Value *component(Code &code, Packing packing, Value *value, int index) {
  llvm::IRBuilder<> &ir = code.ir;
  const bool pair = packing == Packing::Half2 || packing == Packing::Unsigned2;
  Value *const whole = pair ? part(code, value, index & 1, 16) : part(code, value, index, 8);
  switch (packing) {
  case Packing::Half2:
    return floatOf(code, whole);
  case Packing::Unsigned2:
    return ir.CreateFDiv(code.toFloat(whole), code.splat(65535.0f));
  case Packing::Signed4:
    return ir.CreateFDiv(ir.CreateFSub(code.toFloat(whole), code.splat(128.0f)),
                         code.splat(127.0f));
  case Packing::Unsigned4:
    break;
  }
  return ir.CreateFDiv(code.toFloat(whole), code.splat(255.0f));
}
} // namespace

Value *packed(Code &code, Packing packing, const Vec &value) {
  llvm::SmallVector<Value *, 4> parts;
  switch (packing) {
  case Packing::Half2:
    return joined(code, {halfOf(code, value[0]), halfOf(code, value[1])}, 16);
  case Packing::Unsigned2:
    return joined(code, {scaled(code, value[0], 0, 65535, 0), scaled(code, value[1], 0, 65535, 0)},
                  16);
  case Packing::Signed4:
    for (Value *const each : value)
      parts.push_back(scaled(code, each, -128.0f / 127.0f, 127, 128));
    break;
  case Packing::Unsigned4:
    for (Value *const each : value)
      parts.push_back(scaled(code, each, 0, 255, 0));
  }
  return joined(code, parts, 8);
}

Vec unpacked(Code &code, Packing packing, Value *value, unsigned needed) {
  Vec result = {};
  for (int i = 0; i < 4; ++i)
    if (needed >> i & 1)
      result[std::size_t(i)] = component(code, packing, value, i);
  return result;
}

} // namespace arbiter::fp::llvm_back
