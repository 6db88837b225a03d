#include "fp_compiler/back/llvm/pixel/blend_bytes.h"

#include <vector>

#include <llvm/IR/IntrinsicsX86.h>

namespace arbiter::fp::llvm_back {

namespace {

/// A blend factor as bytes in 255ths, four bytes in each lane.
struct ByteFactor {
  Value *bytes = nullptr; ///< null for one or zero
  bool isZero = false;
  bool isAlike = false; ///< all bytes of a pixel are equal
};

/// Computes one blend. Values have four bytes in each lane, in the pixel's order.
class ByteBlend {
public:
  ByteBlend(Code &code, const abi::Format &format, int sourceAlpha, const Vec &constant)
      : m_code(code), m_format(format), m_sourceAlpha(sourceAlpha), m_constant(constant) {}

  Value *run(const abi::BlendKey &key, Value *source, Value *dest) {
    m_source = ofBytes(source);
    m_dest = ofBytes(dest);
    const abi::From alphaPlace = m_format.swizzle[3];
    m_destAlpha = alphaPlace <= abi::From::C3 ? spread(m_dest, int(alphaPlace))
                                              : llvm::Constant::getAllOnesValue(bytes());
    const bool same = key.color == key.alpha && key.sourceColor == key.sourceAlpha &&
                      key.destColor == key.destAlpha && !saturates(key);
    Value *result = equated(key.color, key.sourceColor, key.destColor, false);
    if (!same)
      result = withAlpha(result, equated(key.alpha, key.sourceAlpha, key.destAlpha, true));
    return m_code.ir.CreateOr(m_code.ir.CreateBitCast(result, m_code.i32), constantBits());
  }

private:
  [[nodiscard]] int count() const { return 4 * m_code.lanes; }
  [[nodiscard]] llvm::FixedVectorType *bytes() const {
    return llvm::FixedVectorType::get(m_code.ir.getInt8Ty(), unsigned(count()));
  }
  [[nodiscard]] llvm::FixedVectorType *words() const {
    return llvm::FixedVectorType::get(m_code.ir.getInt16Ty(), unsigned(count()) / 2);
  }
  Value *word(unsigned value) { return llvm::ConstantInt::get(words(), value); }
  Value *ofBytes(Value *pixels) { return m_code.ir.CreateBitCast(pixels, bytes()); }
  Value *rest(Value *value) { return m_code.ir.CreateNot(value); }

  /// Permutes the bytes of each pixel: byte k is replaced by byte `from(k)`.
  template <typename From> Value *shuffled(Value *value, From from) {
    std::vector<int> indices;
    indices.reserve(std::size_t(count()));
    for (int i = 0; i < count(); ++i)
      indices.push_back(i / 4 * 4 + from(i % 4));
    return m_code.ir.CreateShuffleVector(value, indices);
  }
  Value *spread(Value *value, int place) {
    return shuffled(value, [place](int) { return place; });
  }
  static bool saturates(const abi::BlendKey &key) {
    return key.sourceColor == abi::BlendFactor::SourceAlphaSaturate ||
           key.destColor == abi::BlendFactor::SourceAlphaSaturate;
  }
  /// Returns `color`, but with the bytes of `alpha` where the pixel stores alpha.
  Value *withAlpha(Value *color, Value *alpha) {
    std::vector<int> indices;
    indices.reserve(std::size_t(count()));
    for (int i = 0; i < count(); ++i)
      indices.push_back(componentOf(m_format, i % 4) == 3 ? count() + i : i);
    return m_code.ir.CreateShuffleVector(color, alpha, indices);
  }
  /// Returns a mask of the pixel bytes that store no component. They are 255.
  Value *constantBits() {
    std::uint32_t bits = 0;
    for (int k = 0; k < 4; ++k)
      if (componentOf(m_format, k) < 0)
        bits |= 0xFFu << 8 * k;
    return m_code.splat(int(bits));
  }
  /// Returns the blend colour in the pixel's order, or its alpha in all bytes.
  Value *constant(bool onlyAlpha) {
    Vec color = m_constant;
    if (onlyAlpha)
      color.fill(m_constant[3]);
    return ofBytes(packPixels(m_code, {abi::Layout::U8x4, m_format.swizzle}, color));
  }

  ByteFactor factor(abi::BlendFactor kind, bool ofAlpha) {
    switch (kind) {
    case abi::BlendFactor::Zero:
      return {.isZero = true};
    case abi::BlendFactor::One:
      return {};
    case abi::BlendFactor::SourceColor:
      return {m_source};
    case abi::BlendFactor::OneMinusSourceColor:
      return {rest(m_source)};
    case abi::BlendFactor::DestColor:
      return {m_dest};
    case abi::BlendFactor::OneMinusDestColor:
      return {rest(m_dest)};
    case abi::BlendFactor::SourceAlpha:
      return {spread(m_source, m_sourceAlpha), false, true};
    case abi::BlendFactor::OneMinusSourceAlpha:
      return {rest(spread(m_source, m_sourceAlpha)), false, true};
    case abi::BlendFactor::DestAlpha:
      return {m_destAlpha, false, true};
    case abi::BlendFactor::OneMinusDestAlpha:
      return {rest(m_destAlpha), false, true};
    case abi::BlendFactor::ConstantColor:
      return {constant(false)};
    case abi::BlendFactor::OneMinusConstantColor:
      return {rest(constant(false))};
    case abi::BlendFactor::ConstantAlpha:
      return {constant(true)};
    case abi::BlendFactor::OneMinusConstantAlpha:
      return {rest(constant(true))};
    case abi::BlendFactor::SourceAlphaSaturate:
      if (ofAlpha)
        return {};
      return {m_code.ir.CreateBinaryIntrinsic(llvm::Intrinsic::umin,
                                              spread(m_source, m_sourceAlpha), rest(m_destAlpha)),
              false, true};
    }
    llvm_unreachable("a blend factor");
  }

  /// Returns the upper half of the product of words.
  Value *upperHalf(Value *a, Value *b) {
    static constexpr std::array<llvm::Intrinsic::ID, 3> kX86 = {
        llvm::Intrinsic::x86_avx512_pmulhu_w_512, llvm::Intrinsic::x86_avx2_pmulhu_w,
        llvm::Intrinsic::x86_sse2_pmulhu_w}; // by family
    llvm::IRBuilder<> &ir = m_code.ir;
    if (m_code.cpu.family != Cpu::Family::Neon)
      return ir.CreateIntrinsic(kX86[std::size_t(m_code.cpu.family)], {}, {a, b});
    auto *const wide = llvm::FixedVectorType::get(ir.getInt32Ty(), unsigned(count()) / 2);
    Value *const product = ir.CreateMul(ir.CreateZExt(a, wide), ir.CreateZExt(b, wide));
    return ir.CreateTrunc(ir.CreateLShr(product, 16), words());
  }
  /// Returns the upper half of the product, rounded at its upper byte.
  Value *upper(Value *a, Value *b) { return m_code.ir.CreateAdd(upperHalf(a, b), word(128)); }

  /// Returns the product of bytes in 255ths, rounded to nearest; null for zero. A byte b repeated
  /// in a word is 257 * b. The nearest integer to v * b / 255 is that to v * 257 * b / 65536.
  Value *product(Value *value, const ByteFactor &by) {
    llvm::IRBuilder<> &ir = m_code.ir;
    if (by.isZero || !by.bytes)
      return by.isZero ? nullptr : value;
    const auto doubled = [&](int parity) {
      Value *const two =
          by.isAlike ? by.bytes : shuffled(by.bytes, [parity](int k) { return (k & 2) | parity; });
      return ir.CreateBitCast(two, words());
    };
    Value *const pairs = ir.CreateBitCast(value, words());
    Value *const even = upper(ir.CreateShl(pairs, word(8)), doubled(0));
    Value *const odd = upper(ir.CreateAnd(pairs, word(0xFF00)), doubled(1));
    return ofBytes(ir.CreateOr(ir.CreateLShr(even, word(8)), ir.CreateAnd(odd, word(0xFF00))));
  }

  Value *equated(abi::BlendEquation equation, abi::BlendFactor sourceKind,
                 abi::BlendFactor destKind, bool ofAlpha) {
    const auto binary = [this](llvm::Intrinsic::ID id, Value *a, Value *b) {
      return m_code.ir.CreateBinaryIntrinsic(id, a, b);
    };
    if (equation == abi::BlendEquation::Min)
      return binary(llvm::Intrinsic::umin, m_source, m_dest);
    if (equation == abi::BlendEquation::Max)
      return binary(llvm::Intrinsic::umax, m_source, m_dest);
    Value *const none = llvm::Constant::getNullValue(bytes());
    Value *a = product(m_source, factor(sourceKind, ofAlpha));
    Value *b = product(m_dest, factor(destKind, ofAlpha));
    if (equation == abi::BlendEquation::ReverseSubtract)
      std::swap(a, b);
    if (equation != abi::BlendEquation::Add)
      return !a ? none : !b ? a : binary(llvm::Intrinsic::usub_sat, a, b);
    return !a && !b ? none : !a ? b : !b ? a : binary(llvm::Intrinsic::uadd_sat, a, b);
  }

  Code &m_code;
  const abi::Format &m_format;
  const int m_sourceAlpha;
  const Vec &m_constant;
  Value *m_source = nullptr, *m_dest = nullptr, *m_destAlpha = nullptr;
};

} // namespace

Value *blendBytes(Code &code, const abi::Format &format, const abi::BlendKey &key, Value *source,
                  int sourceAlpha, Value *dest, const Vec &constant) {
  return ByteBlend(code, format, sourceAlpha, constant).run(key, source, dest);
}

} // namespace arbiter::fp::llvm_back
