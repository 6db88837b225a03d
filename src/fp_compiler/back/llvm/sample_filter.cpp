#include "fp_compiler/back/llvm/sample_parts.h"

#include <llvm/IR/IntrinsicsX86.h>

/// Nearest and linear filters of one image. Texels of 8-bit components are filtered as integers
/// with weights of 14 bits: exact to 0.05 of their 255 steps, the same on every processor and
/// whichever way the texels were read, and exactly the texel where it has all the weight.
namespace arbiter::fp::llvm_back {
namespace {

using abi::From;
using abi::Layout;

constexpr int kWeightBits = 14;
constexpr int kFullWeight = 1 << kWeightBits;

AxisKey axisKey(const abi::SamplerKey &key, int axis) {
  return {key.dimension == abi::Dimension::Cube ? abi::Wrap::ClampToEdge
                                                : key.wrap[std::size_t(axis)],
          key.dimension != abi::Dimension::Rect, key.powerOfTwo != 0};
}

std::array<AxisTexels, 3> texelsOf(Code &code, const Lookup &lookup, bool linear) {
  std::array<AxisTexels, 3> axes;
  for (int i = 0; i < lookup.dimensions; ++i) {
    const auto at = std::size_t(i);
    const auto find = linear ? linearTexels : nearestTexel;
    axes[at] = find(code, axisKey(lookup.key, i), lookup.coordinate[at], lookup.image.size[at]);
  }
  return axes;
}

/// a + b, where either may be null.
Value *sum(Code &code, Value *a, Value *b) { return !a ? b : !b ? a : code.ir.CreateAdd(a, b); }
Value *anyOf(Code &code, Value *a, Value *b) { return !a ? b : !b ? a : code.ir.CreateOr(a, b); }

/// What index[which] of a dimension adds to a texel's index in the image.
Value *stepOf(Code &code, const Lookup &lookup, const AxisTexels &axis, int dimension, int which) {
  Value *const index = axis.index[std::size_t(which)];
  if (dimension == 0 || !index)
    return index;
  return code.ir.CreateMul(index, code.splat(lookup.image.stride[std::size_t(dimension - 1)]));
}

// --- 8-bit components, as integers

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

/// A fraction as an integer weight, rounded. Adding 2^9 leaves just these bits at the low end.
Value *weightOf(Code &code, Value *fraction) {
  Value *const bits =
      code.ir.CreateBitCast(code.ir.CreateFAdd(fraction, code.splat(512.0f)), code.i32);
  return code.ir.CreateAnd(bits, code.splat(2 * kFullWeight - 1));
}

Value *pair(Code &code, Value *low, Value *high) {
  return code.ir.CreateOr(low, code.ir.CreateShl(high, code.splat(16)));
}

/// Pairs of weights: of the row's first and second texel. Four of them sum up to kFullWeight.
struct Weights {
  Value *row0 = nullptr, *row1 = nullptr;
};
Weights weightsOf(Code &code, Value *fractionX, Value *fractionY) {
  Value *const full = code.splat(kFullWeight);
  Value *const x = weightOf(code, fractionX);
  if (!fractionY)
    return {pair(code, code.ir.CreateSub(full, x), x), nullptr};
  Value *const y = weightOf(code, fractionY);
  Value *const both = code.ir.CreateLShr(
      code.ir.CreateAdd(dot2(code, x, y), code.splat(kFullWeight / 2)), code.splat(kWeightBits));
  Value *const onlyX = code.ir.CreateSub(x, both);
  Value *const onlyY = code.ir.CreateSub(y, both);
  return {pair(code, code.ir.CreateSub(code.ir.CreateSub(full, x), onlyY), onlyX),
          pair(code, onlyY, both)};
}

/// Component `component` of two texels as a pair of 16-bit numbers.
Value *componentPair(Code &code, Value *first, Value *second, int component) {
  const int low = component / 2 * 16;
  Value *halves; // two components each
  if (low == 0)
    halves = code.ir.CreateOr(code.ir.CreateAnd(first, code.splat(0xFFFF)),
                              code.ir.CreateShl(second, code.splat(16)));
  else
    halves = code.ir.CreateOr(code.ir.CreateLShr(first, code.splat(16)),
                              code.ir.CreateAnd(second, code.splat(int(0xFFFF0000u))));
  if (component % 2)
    halves = code.ir.CreateLShr(halves, code.splat(8));
  return code.ir.CreateAnd(halves, code.splat(0x00FF00FF));
}

Vec linearBytes(Code &code, const Lookup &lookup, const std::array<AxisTexels, 3> &axes) {
  const bool flat = lookup.dimensions == 1;
  const Weights weights = weightsOf(code, axes[0].fraction, flat ? nullptr : axes[1].fraction);
  const auto slice = [&](int z) {
    Value *const start = stepOf(code, lookup, axes[2], 2, z);
    Value *row0 = sum(code, start, stepOf(code, lookup, axes[1], 1, 0));
    Value *const row1 = sum(code, start, stepOf(code, lookup, axes[1], 1, 1));
    if (!row0)
      row0 = code.splat(0);
    const auto texels =
        fetchFootprint(code, lookup.lanes, lookup.image, axes[0], row0, flat ? nullptr : row1);
    Vec result = {};
    Vec stored = {};
    for (std::size_t i = 0; i < 4; ++i) {
      const From from = lookup.image.format.swizzle[i];
      if (!(lookup.needed >> i & 1))
        continue;
      if (from > From::C3) {
        result[i] = code.splat(from == From::One ? 1.0f : 0.0f);
        continue;
      }
      Value *&component = stored[std::size_t(from)];
      if (!component) {
        Value *total =
            dot2(code, componentPair(code, texels[0], texels[1], int(from)), weights.row0);
        if (!flat)
          total = code.ir.CreateAdd(
              total,
              dot2(code, componentPair(code, texels[2], texels[3], int(from)), weights.row1));
        // With all weight on one texel this is decode's product, to the bit.
        component =
            code.ir.CreateFMul(code.toFloat(total), code.splat(1.0f / 255.0f / float(kFullWeight)));
      }
      result[i] = component;
    }
    return result;
  };
  Vec result = slice(0);
  if (lookup.dimensions == 3) {
    const Vec behind = slice(1);
    for (std::size_t i = 0; i < 4; ++i)
      if (result[i])
        result[i] = lerp(code, result[i], behind[i], axes[2].fraction);
  }
  return result;
}

bool hasBytes(Layout layout) {
  return layout == Layout::U8x1 || layout == Layout::U8x2 || layout == Layout::U8x4;
}

// --- Any format, as floats

Vec borderColor(Code &code, const Lookup &lookup) {
  Vec color = {};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t from = lookup.key.shadow ? std::size_t(lookup.borderDepth) : i;
    if (lookup.needed >> i & 1)
      color[i] =
          code.splat(constantField(code, code.ir.getFloatTy(), lookup.view,
                                   offsetof(abi::TextureView, borderColor) + from * sizeof(float)));
  }
  return color;
}

/// 1 or 0: 3.8.14.
Value *compared(Code &code, abi::Compare compare, Value *reference, Value *depth) {
  using Predicate = llvm::CmpInst::Predicate;
  constexpr Predicate kPredicates[] = {
      Predicate::FCMP_FALSE, Predicate::FCMP_OLT, Predicate::FCMP_OEQ, Predicate::FCMP_OLE,
      Predicate::FCMP_OGT,   Predicate::FCMP_UNE, Predicate::FCMP_OGE, Predicate::FCMP_TRUE};
  Value *const passes = code.ir.CreateFCmp(kPredicates[int(compare)], reference, depth);
  return code.select(passes, code.splat(1.0f), code.splat(0.0f));
}

/// The texel at one choice of indices, of the border where a dimension is outside.
Texel texelAt(Code &code, const Lookup &lookup, const std::array<AxisTexels, 3> &axes,
              const std::array<int, 3> &which) {
  Value *index = nullptr, *outside = nullptr;
  for (int i = 0; i < lookup.dimensions; ++i) {
    const auto at = std::size_t(i);
    index = sum(code, index, stepOf(code, lookup, axes[at], i, which[at]));
    outside = anyOf(code, outside, axes[at].outside[std::size_t(which[at])]);
  }
  const unsigned used = wordsNeeded(lookup.image.format, lookup.needed);
  const Words words = fetchTexels(code, lookup.lanes, lookup.image, index, used);
  Texel texel;
  texel.rgba = decodeWords(code, lookup.image.format, words, lookup.needed);
  if (outside) {
    const Vec border = borderColor(code, lookup);
    for (std::size_t i = 0; i < 4; ++i)
      if (texel.rgba[i])
        texel.rgba[i] = code.select(outside, border[i], texel.rgba[i]);
  } else if (lookup.image.format.layout == Layout::U8x4) {
    texel.packed = words[0];
  }
  if (lookup.key.shadow)
    texel.rgba[0] = compared(code, lookup.key.compare, lookup.reference, texel.rgba[0]);
  return texel;
}

} // namespace

Value *lerp(Code &code, Value *a, Value *b, Value *weight) {
  return code.ir.CreateFAdd(a, code.ir.CreateFMul(weight, code.ir.CreateFSub(b, a)));
}

Texel filterNearest(Code &code, const Lookup &lookup) {
  return texelAt(code, lookup, texelsOf(code, lookup, false), {});
}

Vec filterLinear(Code &code, const Lookup &lookup) {
  const std::array<AxisTexels, 3> axes = texelsOf(code, lookup, true);
  bool border = false;
  for (const AxisTexels &axis : axes)
    border |= axis.outside[0] != nullptr;
  if (hasBytes(lookup.image.format.layout) && !border && !lookup.key.shadow)
    return linearBytes(code, lookup, axes);
  // Corners are folded dimension by dimension: along x first.
  std::vector<Vec> corners;
  for (int i = 0; i < 1 << lookup.dimensions; ++i)
    corners.push_back(texelAt(code, lookup, axes, {i & 1, i >> 1 & 1, i >> 2 & 1}).rgba);
  for (const AxisTexels &axis : axes) {
    if (!axis.fraction)
      break;
    for (std::size_t i = 0; i < corners.size() / 2; ++i)
      for (std::size_t c = 0; c < 4; ++c)
        corners[i][c] = corners[2 * i][c]
                            ? lerp(code, corners[2 * i][c], corners[2 * i + 1][c], axis.fraction)
                            : nullptr;
    corners.resize(corners.size() / 2);
  }
  return corners[0];
}

} // namespace arbiter::fp::llvm_back
