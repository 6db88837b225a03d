#include "fp_compiler/back/llvm/pixel/blend_bytes.h"
#include "fp_compiler/back/llvm/pixel/pixel.h"

/// Blending (4.1.7 of OpenGL 1.4). Buffers of four bytes use byte arithmetic. Others use floats,
/// which are rounded once when the result is stored.
namespace arbiter::fp::llvm_back {

namespace {
struct Operands {
  const Vec &source, &dest;
  Vec constant; ///< GL_BLEND_COLOR
};

/// Returns the factor of component \p c of a colour; null for one.
Value *factor(Code &code, abi::BlendFactor kind, const Operands &in, std::size_t c) {
  llvm::IRBuilder<> &ir = code.ir;
  const auto rest = [&](Value *value) { return ir.CreateFSub(code.splat(1.0f), value); };
  switch (kind) {
  case abi::BlendFactor::Zero:
    return code.splat(0.0f);
  case abi::BlendFactor::One:
    return nullptr;
  case abi::BlendFactor::SourceColor:
    return in.source[c];
  case abi::BlendFactor::OneMinusSourceColor:
    return rest(in.source[c]);
  case abi::BlendFactor::DestColor:
    return in.dest[c];
  case abi::BlendFactor::OneMinusDestColor:
    return rest(in.dest[c]);
  case abi::BlendFactor::SourceAlpha:
    return in.source[3];
  case abi::BlendFactor::OneMinusSourceAlpha:
    return rest(in.source[3]);
  case abi::BlendFactor::DestAlpha:
    return in.dest[3];
  case abi::BlendFactor::OneMinusDestAlpha:
    return rest(in.dest[3]);
  case abi::BlendFactor::ConstantColor:
    return in.constant[c];
  case abi::BlendFactor::OneMinusConstantColor:
    return rest(in.constant[c]);
  case abi::BlendFactor::ConstantAlpha:
    return in.constant[3];
  case abi::BlendFactor::OneMinusConstantAlpha:
    return rest(in.constant[3]);
  case abi::BlendFactor::SourceAlphaSaturate:
    return c == 3 ? nullptr : code.min(in.source[3], rest(in.dest[3]));
  }
  llvm_unreachable("a blend factor");
}

/// Returns the product with a factor; null for zero. A zero factor gives zero for any value.
Value *scaledByFactor(Code &code, abi::BlendFactor kind, const Operands &in, std::size_t c,
                      Value *value) {
  if (kind == abi::BlendFactor::Zero)
    return nullptr;
  Value *const by = factor(code, kind, in, c);
  return by ? code.ir.CreateFMul(value, by) : value;
}
} // namespace

Value *PixelWriter::blendedBytes(const FragmentColors &fragment, std::size_t target, Value *old) {
  const abi::ColorTargetKey &key = m_key.targets[target];
  Vec constant = {};
  for (std::size_t c = 0; c < 4; ++c)
    constant[c] = uniform(offsetof(abi::FragmentData, blendColor) + sizeof(float) * c, true);
  const abi::From alpha = key.format.swizzle[3];
  if (alpha <= abi::From::C3)
    return blendBytes(m_code, key.format, key.blend, pixelsOf(fragment, target), int(alpha), old,
                      constant);
  // The format has no alpha, so that the source's alpha uses an unused byte of the pixel.
  int spare = 0;
  while (spare < 3 && componentOf(key.format, spare) >= 0)
    ++spare;
  abi::Format whole = key.format;
  whole.swizzle[3] = abi::From(spare);
  return blendBytes(m_code, key.format, key.blend,
                    packPixels(m_code, whole, fragment.colors[target]), spare, old, constant);
}

Vec PixelWriter::blended(const Vec &source, const Vec &dest, const abi::BlendKey &key,
                         bool fixedPoint) {
  llvm::IRBuilder<> &ir = m_code.ir;
  Operands in{source, dest, {}};
  for (std::size_t c = 0; c < 4; ++c)
    in.constant[c] =
        uniform(offsetof(abi::FragmentData, blendColor) + sizeof(float) * c, fixedPoint);
  Vec result = {};
  for (std::size_t c = 0; c < 4; ++c) {
    const abi::BlendEquation equation = c == 3 ? key.alpha : key.color;
    if (equation == abi::BlendEquation::Min || equation == abi::BlendEquation::Max) {
      result[c] = equation == abi::BlendEquation::Min ? m_code.min(source[c], dest[c])
                                                      : m_code.max(source[c], dest[c]);
      continue;
    }
    Value *a = scaledByFactor(m_code, c == 3 ? key.sourceAlpha : key.sourceColor, in, c, source[c]);
    Value *b = scaledByFactor(m_code, c == 3 ? key.destAlpha : key.destColor, in, c, dest[c]);
    if (equation == abi::BlendEquation::ReverseSubtract)
      std::swap(a, b);
    const bool adds = equation == abi::BlendEquation::Add;
    Value *const zero = m_code.splat(0.0f);
    if (!b || (!a && adds))
      result[c] = a ? a : b ? b : zero;
    else
      result[c] = adds ? ir.CreateFAdd(a, b) : ir.CreateFSub(a ? a : zero, b);
  }
  return result;
}

} // namespace arbiter::fp::llvm_back
