#include "fp_compiler/back/llvm/pixel/pixel.h"

namespace arbiter::fp::llvm_back {

namespace {
Value *combined(Code &code, abi::LogicOp op, Value *source, Value *dest) {
  llvm::IRBuilder<> &ir = code.ir;
  switch (op) {
  case abi::LogicOp::Clear:
    return llvm::Constant::getNullValue(source->getType());
  case abi::LogicOp::And:
    return ir.CreateAnd(source, dest);
  case abi::LogicOp::AndReverse:
    return ir.CreateAnd(source, ir.CreateNot(dest));
  case abi::LogicOp::Copy:
    return source;
  case abi::LogicOp::AndInverted:
    return ir.CreateAnd(ir.CreateNot(source), dest);
  case abi::LogicOp::Noop:
    return dest;
  case abi::LogicOp::Xor:
    return ir.CreateXor(source, dest);
  case abi::LogicOp::Or:
    return ir.CreateOr(source, dest);
  case abi::LogicOp::Nor:
    return ir.CreateNot(ir.CreateOr(source, dest));
  case abi::LogicOp::Equiv:
    return ir.CreateNot(ir.CreateXor(source, dest));
  case abi::LogicOp::Invert:
    return ir.CreateNot(dest);
  case abi::LogicOp::OrReverse:
    return ir.CreateOr(source, ir.CreateNot(dest));
  case abi::LogicOp::CopyInverted:
    return ir.CreateNot(source);
  case abi::LogicOp::OrInverted:
    return ir.CreateOr(ir.CreateNot(source), dest);
  case abi::LogicOp::Nand:
    return ir.CreateNot(ir.CreateAnd(source, dest));
  case abi::LogicOp::Set:
    return llvm::Constant::getAllOnesValue(source->getType());
  }
  llvm_unreachable("a logic operation");
}
} // namespace

Value *compared(Code &code, abi::Compare compare, Value *a, Value *b) {
  using Predicate = llvm::CmpInst::Predicate;
  static constexpr Predicate kFloats[] = {
      Predicate::FCMP_FALSE, Predicate::FCMP_OLT, Predicate::FCMP_OEQ, Predicate::FCMP_OLE,
      Predicate::FCMP_OGT,   Predicate::FCMP_UNE, Predicate::FCMP_OGE, Predicate::FCMP_TRUE};
  static constexpr Predicate kIntegers[] = {
      Predicate::BAD_ICMP_PREDICATE, Predicate::ICMP_SLT,          Predicate::ICMP_EQ,
      Predicate::ICMP_SLE,           Predicate::ICMP_SGT,          Predicate::ICMP_NE,
      Predicate::ICMP_SGE,           Predicate::BAD_ICMP_PREDICATE};
  if (compare == abi::Compare::Always || compare == abi::Compare::Never)
    return compare == abi::Compare::Always ? llvm::Constant::getAllOnesValue(code.i1)
                                           : llvm::Constant::getNullValue(code.i1);
  if (a->getType()->getScalarType()->isIntegerTy())
    return code.ir.CreateICmp(kIntegers[int(compare)], a, b);
  return code.ir.CreateFCmp(kFloats[int(compare)], a, b);
}

bool PixelWriter::supports(const abi::FragmentKey &key, std::string &reason) {
  for (const abi::ColorTargetKey &target : key.targets)
    if (target.format.layout != abi::Layout::None && !isDrawable(target.format.layout)) {
      reason = "a colour buffer of a layout that is not drawn to";
      return false;
    }
  return true;
}

void PixelWriter::setPixel(Value *x, Value *y) {
  for (std::size_t i = 0; i < m_key.targets.size(); ++i)
    m_targets.emplace_back(m_code, m_places, m_data,
                           offsetof(abi::FragmentData, targets) + sizeof(abi::Target) * i,
                           abi::bytesOf(m_key.targets[i].format.layout), x, y);
}

Value *PixelWriter::uniform(std::size_t offset, bool clamped) {
  return writeIn(m_code, m_places.entry, [&] {
    Value *const value = m_code.splat(m_code.field(m_code.ir.getFloatTy(), m_data, offset));
    return clamped ? m_code.saturate(value) : value;
  });
}

void PixelWriter::prefetch(const PixelPlace &place) {
  for (std::size_t i = 0; i < m_targets.size(); ++i)
    if (m_key.targets[i].format.layout != abi::Layout::None)
      m_targets[i].prefetch(place);
}

Value *PixelWriter::alphaTested(const PixelPlace &place, const FragmentColors &fragment,
                                Value *mask) {
  if (m_key.alphaTest == abi::Compare::Always)
    return mask;
  Value *alpha = fragment.colors[0][3] ? fragment.colors[0][3] : m_code.splat(0.0f);
  Value *reference = uniform(offsetof(abi::FragmentData, alphaReference));
  if (m_key.targets[0].format.layout == abi::Layout::U8x4) {
    // With eight bits, both values are compared as the buffer stores them (OpenGL 2.1, 4.1.4). For
    // other buffers hosts compare unrounded values.
    const auto rounded = [this](Value *value) {
      Value *const scaled = m_code.ir.CreateFMul(m_code.saturate(value), m_code.splat(255.0f));
      return m_code.ir.CreateUnaryIntrinsic(llvm::Intrinsic::rint, scaled);
    };
    alpha = rounded(alpha);
    reference = writeIn(m_code, m_places.entry, [&] { return rounded(reference); });
  } else if (m_key.clampColors) {
    alpha = m_code.saturate(alpha);
  }
  Value *const passes = compared(m_code, m_key.alphaTest, alpha, reference);
  return m_code.ir.CreateAnd(passes, mask ? mask : place.covered);
}

void PixelWriter::write(const PixelPlace &place, const FragmentColors &fragment, Value *mask) {
  for (std::size_t i = 0; i < m_key.targets.size(); ++i) {
    const abi::ColorTargetKey &target = m_key.targets[i];
    if (target.format.layout == abi::Layout::None || (target.writeMask & 0xF) == 0)
      continue;
    if (!target.blend.enabled || m_key.logicOpEnabled) {
      storePixels(place, pixelsOf(fragment, i), i, mask);
      continue;
    }
    const PixelType type = pixelType(m_code, target.format.layout);
    Value *const old = m_targets[i].load(place, type.type, type.parts);
    if (target.format.layout == abi::Layout::U8x4) {
      storePixels(place, blendedBytes(fragment, i, old), i, mask, old);
      continue;
    }
    // In fixed-point buffers every operand is clamped, regardless of fragment clamping
    // (ARB_color_buffer_float, changes to 4.1.7).
    const bool fixedPoint = !abi::isFloat(target.format.layout);
    Vec source = fragment.colors[i];
    for (Value *&component : source) {
      component = component ? component : m_code.splat(0.0f);
      component = m_key.clampColors || fixedPoint ? m_code.saturate(component) : component;
    }
    const int bits = 8 * abi::bytesOf(target.format.layout);
    Value *const raw =
        bits > 32 ? old
                  : m_code.ir.CreateBitCast(
                        old, llvm::FixedVectorType::get(m_code.ir.getIntNTy(unsigned(bits)),
                                                        unsigned(m_code.lanes)));
    const Vec dest = decode(m_code, target.format, raw, 0xF);
    const Vec result = blended(source, dest, target.blend, fixedPoint);
    storePixels(place, packPixels(m_code, target.format, result), i, mask, old);
  }
}

Value *PixelWriter::pixelsOf(const FragmentColors &fragment, std::size_t target) {
  const abi::ColorTargetKey &key = m_key.targets[target];
  Vec color = fragment.colors[target];
  if (key.format.layout == abi::Layout::U8x4)
    if (Value *const pixels = passedThrough(fragment, color, key))
      return pixels;
  if (m_key.clampColors && abi::isFloat(key.format.layout))
    for (Value *&component : color)
      component = component ? m_code.saturate(component) : nullptr;
  return packPixels(m_code, key.format, color);
}

void PixelWriter::storePixels(const PixelPlace &place, Value *pixels, std::size_t target,
                              Value *mask, Value *old) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const abi::ColorTargetKey &key = m_key.targets[target];
  const PixelType type = pixelType(m_code, key.format.layout);
  const bool logic = m_key.logicOpEnabled && !abi::isFloat(key.format.layout);
  Value *const kept = keptBits(m_code, key.format, key.writeMask);
  if ((kept || logic) && !old)
    old = m_targets[target].load(place, type.type, type.parts);
  if (logic)
    pixels = combined(m_code, m_key.logicOp, pixels, old);
  if (kept)
    pixels = ir.CreateOr(ir.CreateAnd(pixels, ir.CreateNot(kept)), ir.CreateAnd(old, kept));
  m_targets[target].store(place, pixels, type.parts, mask);
}

Value *PixelWriter::passedThrough(const FragmentColors &fragment, const Vec &color,
                                  const abi::ColorTargetKey &target) {
  for (const PackedTexel &texel : fragment.texels) {
    // For each byte of the pixel this is the byte of the texel, or 4 if the byte is 0xFF.
    std::array<int, 4> from = {};
    bool same = texel.packed != nullptr;
    for (int k = 0; same && k < 4; ++k) {
      const int c = componentOf(target.format, k);
      if (c < 0) {
        from[std::size_t(k)] = 4;
        continue;
      }
      same = false;
      for (std::size_t t = 0; t < 4 && !same; ++t) {
        if (!color[std::size_t(c)] || texel.rgba[t] != color[std::size_t(c)])
          continue;
        const abi::From source = texel.swizzle[t];
        same = source != abi::From::Zero;
        from[std::size_t(k)] = source == abi::From::One ? 4 : int(source);
      }
    }
    if (!same)
      continue;
    if (from == std::array{0, 1, 2, 3})
      return texel.packed;
    llvm::IRBuilder<> &ir = m_code.ir;
    const auto bytes = unsigned(4 * m_code.lanes);
    auto *const type = llvm::FixedVectorType::get(ir.getInt8Ty(), bytes);
    std::vector<int> indices;
    for (unsigned i = 0; i < bytes; ++i) {
      const int k = from[i % 4];
      indices.push_back(k == 4 ? int(bytes + i) : int(i / 4 * 4) + k);
    }
    Value *const shuffled = ir.CreateShuffleVector(ir.CreateBitCast(texel.packed, type),
                                                   llvm::Constant::getAllOnesValue(type), indices);
    return ir.CreateBitCast(shuffled, m_code.i32);
  }
  return nullptr;
}

} // namespace arbiter::fp::llvm_back
