#include "fp_compiler/back/llvm/math/math.h"
#include "fp_compiler/back/llvm/sample/sample_parts.h"

/// Nearest and linear filters of one image.
namespace arbiter::fp::llvm_back {
namespace {

using abi::Layout;

AxisKey axisKey(const abi::SamplerKey &key, int axis) {
  return {key.dimension == abi::Dimension::Cube ? abi::Wrap::ClampToEdge
                                                : key.wrap[std::size_t(axis)],
          key.dimension != abi::Dimension::Rect, (key.powerOfTwo >> axis & 1) != 0};
}

std::array<AxisTexels, 3> linearAxes(Code &code, const Lookup &lookup, bool bytes) {
  std::array<AxisTexels, 3> axes;
  for (int i = 0; i < lookup.dimensions; ++i) {
    const auto at = std::size_t(i);
    axes[at] = (bytes ? linearTexelsOfBytes : linearTexels)(
        code, axisKey(lookup.key, i), lookup.coordinate[at], lookup.image.size[at]);
  }
  return axes;
}

Value *anyOf(Code &code, Value *a, Value *b) { return !a ? b : !b ? a : code.ir.CreateOr(a, b); }

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

/// Returns the result of a shadow comparison, 1 or 0 (3.8.14).
Value *compared(Code &code, abi::Compare compare, Value *reference, Value *depth) {
  using Predicate = llvm::CmpInst::Predicate;
  constexpr Predicate kPredicates[] = {
      Predicate::FCMP_FALSE, Predicate::FCMP_OLT, Predicate::FCMP_OEQ, Predicate::FCMP_OLE,
      Predicate::FCMP_OGT,   Predicate::FCMP_UNE, Predicate::FCMP_OGE, Predicate::FCMP_TRUE};
  Value *const passes = code.ir.CreateFCmp(kPredicates[int(compare)], reference, depth);
  return code.select(passes, code.splat(1.0f), code.splat(0.0f));
}

/// Returns the texel at one combination of indices, or the border colour if a dimension is outside.
Texel texelAt(Code &code, const Lookup &lookup, const std::array<AxisTexels, 3> &axes,
              const Steps &steps, const std::array<int, 3> &which) {
  Value *index = nullptr, *outside = nullptr;
  for (int i = 0; i < lookup.dimensions; ++i) {
    const auto at = std::size_t(i);
    Value *const step = steps[at][std::size_t(which[at])];
    index = index ? code.ir.CreateAdd(index, step) : step;
    outside = anyOf(code, outside, axes[at].outside[std::size_t(which[at])]);
  }
  const unsigned used = wordsNeeded(lookup.image.format, lookup.needed);
  Words words = fetchTexels(code, lookup.lanes, lookup.image, index, used);
  abi::Format format = lookup.image.format;
  if (filtersBytes(lookup) && abi::isPacked(format.layout) && used != 0) {
    words[0] = bytesOfPacked(code, format.layout, words[0]);
    format.layout = Layout::U8x4;
  }
  Texel texel;
  texel.rgba = decodeWords(code, format, words, lookup.needed);
  if (outside) {
    const Vec border = borderColor(code, lookup);
    for (std::size_t i = 0; i < 4; ++i)
      if (texel.rgba[i])
        texel.rgba[i] = code.select(outside, border[i], texel.rgba[i]);
  } else if (abi::isPlainWord(format) || filtersBytes(lookup)) {
    texel.packed = words[0];
  }
  if (lookup.key.shadow)
    texel.rgba[0] = compared(code, lookup.key.compare, lookup.reference, texel.rgba[0]);
  return texel;
}

} // namespace

bool filtersBytes(const Lookup &lookup) {
  if (!fitsBytes(lookup.key.format))
    return false;
  for (int i = 0; i < lookup.dimensions; ++i)
    if (!isSimple(axisKey(lookup.key, i).wrap))
      return false;
  return true;
}

Value *lerp(Code &code, Value *a, Value *b, Value *weight) {
  return multiplyAdd(code, weight, code.ir.CreateFSub(b, a), a); // in the order of hosts
}

Steps stepsOf(Code &code, const ImageCode &image, const std::array<AxisTexels, 3> &axes,
              int dimensions) {
  llvm::IRBuilder<> &ir = code.ir;
  Steps steps = {axes[0].index};
  for (int i = 1; i < dimensions; ++i) {
    const auto at = std::size_t(i);
    const AxisTexels &axis = axes[at];
    Value *const stride = code.splat(image.stride[at - 1]);
    Value *const first = ir.CreateMul(axis.index[0], stride);
    steps[at][0] = first;
    if (!axis.index[1])
      continue;
    // Integer products are slow, so the second step is derived from the first.
    Value *const last =
        ir.CreateICmpEQ(axis.index[0], code.splat(ir.CreateSub(image.size[at], ir.getInt32(1))));
    Value *const second = ir.CreateAdd(first, stride);
    steps[at][1] = axis.next == AxisTexels::Next::Edge ? code.select(last, first, second)
                   : axis.next == AxisTexels::Next::Repeat
                       ? code.select(last, code.splat(0), second)
                       : ir.CreateMul(axis.index[1], stride);
  }
  return steps;
}

Texel filterNearest(Code &code, const Lookup &lookup) {
  std::array<AxisTexels, 3> axes;
  for (int i = 0; i < lookup.dimensions; ++i) {
    const auto at = std::size_t(i);
    axes[at] =
        nearestTexel(code, axisKey(lookup.key, i), lookup.coordinate[at], lookup.image.size[at]);
  }
  return texelAt(code, lookup, axes, stepsOf(code, lookup.image, axes, lookup.dimensions), {});
}

Texel filterLinear(Code &code, const Lookup &lookup) {
  if (filtersBytes(lookup))
    return filterBytes(code, lookup, linearAxes(code, lookup, true));
  const std::array<AxisTexels, 3> axes = linearAxes(code, lookup, false);
  const Steps steps = stepsOf(code, lookup.image, axes, lookup.dimensions);
  // Corners are interpolated dimension by dimension, along x first.
  llvm::SmallVector<Vec, 8> corners;
  for (int i = 0; i < 1 << lookup.dimensions; ++i)
    corners.push_back(texelAt(code, lookup, axes, steps, {i & 1, i >> 1 & 1, i >> 2 & 1}).rgba);
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
  return {corners[0]};
}

} // namespace arbiter::fp::llvm_back
