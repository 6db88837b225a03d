#include "fp_compiler/back/llvm/sample/sample_parts.h"

#include <llvm/IR/IntrinsicsX86.h>

/// The linear filter of texels of 8-bit components, as integers with weights of 14 bits: exact to
/// 0.05 of their 255 steps, the same on every processor and whichever way the texels were read, and
/// exactly the texel where it has all the weight.
namespace arbiter::fp::llvm_back {
namespace {

using abi::From;

constexpr int kFullWeight = 1 << kWeightBits;

/// Products of signed 16-bit halves, summed in pairs: low * low + high * high.
Value *dot2(Code &code, Value *a, Value *b) {
  llvm::Intrinsic::ID id = llvm::Intrinsic::not_intrinsic;
  switch (code.cpu.family) {
  case Cpu::Family::Avx512:
    id = llvm::Intrinsic::x86_avx512_pmaddw_d_512;
    break;
  case Cpu::Family::Avx2:
    id = llvm::Intrinsic::x86_avx2_pmadd_wd;
    break;
  case Cpu::Family::Sse41:
    id = llvm::Intrinsic::x86_sse2_pmadd_wd;
    break;
  case Cpu::Family::Neon: {
    const auto low = [&](Value *v) {
      return code.ir.CreateAShr(code.ir.CreateShl(v, code.splat(16)), code.splat(16));
    };
    const auto high = [&](Value *v) { return code.ir.CreateAShr(v, code.splat(16)); };
    return code.ir.CreateAdd(code.ir.CreateMul(low(a), low(b)),
                             code.ir.CreateMul(high(a), high(b)));
  }
  }
  auto *const halves = llvm::FixedVectorType::get(code.ir.getInt16Ty(), unsigned(code.lanes) * 2);
  return code.ir.CreateIntrinsic(
      id, {}, {code.ir.CreateBitCast(a, halves), code.ir.CreateBitCast(b, halves)});
}

/// 16-bit halves: (a * b + 2^14) >> 15.
Value *multiplyHigh(Code &code, Value *a, Value *b) {
  auto *const halves = llvm::FixedVectorType::get(code.ir.getInt16Ty(), unsigned(code.lanes) * 2);
  llvm::Intrinsic::ID id = llvm::Intrinsic::not_intrinsic;
  switch (code.cpu.family) {
  case Cpu::Family::Avx512:
    id = llvm::Intrinsic::x86_avx512_pmul_hr_sw_512;
    break;
  case Cpu::Family::Avx2:
    id = llvm::Intrinsic::x86_avx2_pmul_hr_sw;
    break;
  case Cpu::Family::Sse41:
    id = llvm::Intrinsic::x86_ssse3_pmul_hr_sw_128;
    break;
  case Cpu::Family::Neon: {
    auto *const words = llvm::FixedVectorType::get(code.ir.getInt32Ty(), unsigned(code.lanes) * 2);
    const auto wide = [&](Value *v) {
      return code.ir.CreateSExt(code.ir.CreateBitCast(v, halves), words);
    };
    Value *const half = llvm::ConstantInt::get(words, 1 << 14);
    Value *const product = code.ir.CreateAdd(code.ir.CreateMul(wide(a), wide(b)), half);
    return code.ir.CreateBitCast(code.ir.CreateTrunc(code.ir.CreateAShr(product, 15), halves),
                                 code.i32);
  }
  }
  return code.ir.CreateBitCast(
      code.ir.CreateIntrinsic(id, {},
                              {code.ir.CreateBitCast(a, halves), code.ir.CreateBitCast(b, halves)}),
      code.i32);
}

/// Pairs of weights: of the row's first and second texel. Four of them sum up to kFullWeight.
struct Weights {
  Value *row0 = nullptr, *row1 = nullptr;
};
Weights weightsOf(Code &code, Value *x, Value *y) {
  llvm::IRBuilder<> &ir = code.ir;
  // kFullWeight - x in the low half, x in the high one. As a sum LLVM would make a product of it.
  Value *const columns =
      ir.CreateOr(ir.CreateShl(x, code.splat(16)), ir.CreateSub(code.splat(kFullWeight), x));
  if (!y)
    return {columns, nullptr};
  // Twice y in both halves. The full weight would not fit: it is 2^-15 less there.
  Value *const twice =
      ir.CreateBinaryIntrinsic(llvm::Intrinsic::umin, ir.CreateAdd(y, y), code.splat(0x7FFF));
  Value *const rows = ir.CreateOr(twice, ir.CreateShl(twice, code.splat(16)));
  Value *const row1 = multiplyHigh(code, columns, rows);
  // Neither half of row1 is more than its column's.
  return {ir.CreateSub(columns, row1), row1};
}

/// Component `component` of two texels as a pair of 16-bit numbers.
Value *componentPair(Code &code, const TexelPair &texels, int component) {
  Value *halves = component < 2 ? texels.low : texels.high;
  if (component % 2)
    halves = code.ir.CreateLShr(halves, code.splat(8));
  return code.ir.CreateAnd(halves, code.splat(0x00FF00FF));
}

/// A component's weighted sum, times kFullWeight.
Value *weighted(Code &code, const std::array<TexelPair, 2> &rows, const Weights &weights,
                int component) {
  Value *const first = dot2(code, componentPair(code, rows[0], component), weights.row0);
  if (!rows[1].low)
    return first;
  return code.ir.CreateAdd(first,
                           dot2(code, componentPair(code, rows[1], component), weights.row1));
}

/// The sums of all four components rounded to bytes, as a texel.
Value *packedSums(Code &code, const Vec &sums) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *packed = nullptr;
  for (int i = 0; i < 4; ++i) {
    Value *const rounded = ir.CreateAdd(sums[std::size_t(i)], code.splat(kFullWeight / 2));
    const int up = 8 * i - kWeightBits;
    Value *const moved =
        up < 0 ? ir.CreateLShr(rounded, code.splat(-up)) : ir.CreateShl(rounded, code.splat(up));
    Value *const byte =
        i == 0 || i == 3 ? moved : ir.CreateAnd(moved, code.splat(int(0xFFu << 8 * i)));
    // The top byte keeps no fraction below itself.
    Value *const clean = i == 3 ? ir.CreateAnd(byte, code.splat(int(0xFF000000u))) : byte;
    packed = packed ? ir.CreateOr(packed, clean) : clean;
  }
  return packed;
}

/// The filter along x and y, in one slice of a 3D texture.
Texel filterSlice(Code &code, const Lookup &lookup, const AxisTexels &x, Value *row0, Value *row1,
                  const Weights &weights) {
  const auto rows = fetchFootprint(code, lookup.lanes, lookup.image, x, row0, row1);
  const abi::Format &format = lookup.image.format;
  Vec sums = {}, stored = {};
  Texel texel;
  for (std::size_t i = 0; i < 4; ++i) {
    const From from = format.swizzle[i];
    if (!(lookup.needed >> i & 1))
      continue;
    if (from > From::C3) {
      texel.rgba[i] = code.splat(from == From::One ? 1.0f : 0.0f);
      continue;
    }
    const auto at = std::size_t(from);
    if (!stored[at]) {
      sums[at] = weighted(code, rows, weights, int(from));
      // With all weight on one texel this is decode's product, to the bit.
      stored[at] = code.ir.CreateFMul(code.toFloat(sums[at]),
                                      code.splat(1.0f / 255.0f / float(kFullWeight)));
    }
    texel.rgba[i] = stored[at];
  }
  if (sums[0] && sums[1] && sums[2] && sums[3])
    texel.packed = packedSums(code, sums);
  return texel;
}

} // namespace

Texel filterBytes(Code &code, const Lookup &lookup, const std::array<AxisTexels, 3> &axes) {
  const Steps steps = stepsOf(code, lookup.image, axes, lookup.dimensions);
  if (lookup.dimensions == 1)
    return filterSlice(code, lookup, axes[0], code.splat(0), nullptr,
                       weightsOf(code, axes[0].weight, nullptr));
  const Weights weights = weightsOf(code, axes[0].weight, axes[1].weight);
  if (lookup.dimensions == 2)
    return filterSlice(code, lookup, axes[0], steps[1][0], steps[1][1], weights);
  std::array<Texel, 2> slices;
  for (std::size_t z = 0; z < 2; ++z)
    slices[z] = filterSlice(code, lookup, axes[0], code.ir.CreateAdd(steps[1][0], steps[2][z]),
                            code.ir.CreateAdd(steps[1][1], steps[2][z]), weights);
  Value *const depth =
      code.ir.CreateFMul(code.toFloat(axes[2].weight), code.splat(1.0f / float(kFullWeight)));
  Texel texel;
  for (std::size_t i = 0; i < 4; ++i)
    if (slices[0].rgba[i])
      texel.rgba[i] = lerp(code, slices[0].rgba[i], slices[1].rgba[i], depth);
  return texel;
}

} // namespace arbiter::fp::llvm_back
