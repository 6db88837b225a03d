#include "fp_compiler/back/llvm/pixel/pixel_pack.h"

#include <numeric>
#include <vector>

#include <llvm/IR/IntrinsicsX86.h>

#include "fp_compiler/back/llvm/pixel/pixel_range.h"

namespace arbiter::fp::llvm_back {

namespace {
/// Returns bytes in the low bits of each lane, rounded by adding 2^23.
Value *byteBySum(Code &code, Value *value) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *const scaled = ir.CreateFMul(code.saturate(value), code.splat(255.0f));
  Value *const bits = ir.CreateBitCast(ir.CreateFAdd(scaled, code.splat(0x1p23f)), code.i32);
  return ir.CreateAnd(bits, code.splat(255));
}

/// Converts floats to bytes on x86, whose pack instructions saturate. Values below 0 or above 255
/// need no clamp unless they exceed 32 bits. For those and for NaN, the conversion gives the
/// smallest integer.
class X86Packer {
public:
  explicit X86Packer(Code &code) : m_code(code) {}

  Value *integers(Value *value) {
    llvm::IRBuilder<> &ir = m_code.ir;
    Value *scaled = ir.CreateFMul(value, m_code.splat(255.0f));
    const Range range = rangeOf(value);
    if (!(range.high <= 0x1p22f)) {
      // This operand order keeps NaN.
      Value *const most = m_code.splat(255.0f);
      scaled = m_code.select(ir.CreateFCmpOLT(most, scaled), most, scaled);
    }
    switch (m_code.cpu.family) {
    case Cpu::Family::Avx512:
      return ir.CreateIntrinsic(llvm::Intrinsic::x86_avx512_mask_cvtps2dq_512, {},
                                {scaled, llvm::Constant::getNullValue(m_code.i32),
                                 ir.getInt16(0xFFFF), ir.getInt32(kCurrentRounding)});
    case Cpu::Family::Avx2:
      return ir.CreateIntrinsic(llvm::Intrinsic::x86_avx_cvt_ps2dq_256, {}, {scaled});
    default:
      return ir.CreateIntrinsic(llvm::Intrinsic::x86_sse2_cvtps2dq, {}, {scaled});
    }
  }

  /// Packs component vectors to pixels. The x86 instructions work on 128 bits: they give four
  /// pixels by component, which a shuffle reorders by pixel.
  Value *pack(const std::array<Value *, 4> &bytes) {
    llvm::IRBuilder<> &ir = m_code.ir;
    Value *const low = call(kPackWords, bytes[0], bytes[1]);
    Value *const high = call(kPackWords, bytes[2], bytes[3]);
    Value *const planes = call(kPackBytes, low, high);
    std::vector<int> indices;
    indices.reserve(std::size_t(4 * m_code.lanes));
    for (int i = 0; i < 4 * m_code.lanes; ++i)
      indices.push_back(i / 16 * 16 + i % 4 * 4 + i / 4 % 4);
    return ir.CreateBitCast(ir.CreateShuffleVector(planes, indices), m_code.i32);
  }

private:
  static constexpr int kCurrentRounding = 4;
  using Ids = std::array<llvm::Intrinsic::ID, 3>; ///< by family
  static constexpr Ids kPackWords = {llvm::Intrinsic::x86_avx512_packssdw_512,
                                     llvm::Intrinsic::x86_avx2_packssdw,
                                     llvm::Intrinsic::x86_sse2_packssdw_128};
  static constexpr Ids kPackBytes = {llvm::Intrinsic::x86_avx512_packuswb_512,
                                     llvm::Intrinsic::x86_avx2_packuswb,
                                     llvm::Intrinsic::x86_sse2_packuswb_128};

  Value *call(const Ids &ids, Value *a, Value *b) {
    return m_code.ir.CreateIntrinsic(ids[std::size_t(m_code.cpu.family)], {}, {a, b});
  }

  Code &m_code;
};
/// Packs a U8x4 pixel into one i32.
Value *packBytes(Code &code, const abi::Format &format, const Vec &color) {
  std::array<Value *, 4> bytes = {};
  X86Packer packer(code);
  const bool isX86 = code.cpu.family != Cpu::Family::Neon;
  for (int k = 0; k < 4; ++k) {
    const int component = componentOf(format, k);
    Value *const value = component < 0 ? nullptr : color[std::size_t(component)];
    Value *&byte = bytes[std::size_t(k)];
    if (!value)
      byte = code.splat(component < 0 ? 255 : 0);
    else
      byte = isX86 ? packer.integers(value) : byteBySum(code, value);
  }
  if (isX86)
    return packer.pack(bytes);
  Value *pixels = bytes[0];
  for (int k = 1; k < 4; ++k)
    pixels = code.ir.CreateOr(pixels, code.ir.CreateShl(bytes[std::size_t(k)], code.splat(8 * k)));
  return pixels;
}

/// Returns a normalised number of `bits` bits in an i32. Below 2^23, adding 0.5 and truncating
/// rounds to nearest.
Value *normalizedBits(Code &code, Value *value, int bits) {
  const auto most = float((1 << bits) - 1);
  Value *const scaled = code.ir.CreateFMul(code.saturate(value), code.splat(most));
  return code.toInt(code.ir.CreateFAdd(scaled, code.splat(0.5f)));
}

/// Returns half floats in the low bits of an i32. They round towards zero as the software host's
/// do, so that both draw the same. Too large values become the largest number.
Value *halfBits(Code &code, Value *value) {
  llvm::IRBuilder<> &ir = code.ir;
  constexpr int kTowardsZero = 3;
  auto *const halves = llvm::FixedVectorType::get(ir.getInt16Ty(), unsigned(code.lanes));
  if (code.cpu.family == Cpu::Family::Avx512)
    return ir.CreateZExt(
        ir.CreateIntrinsic(llvm::Intrinsic::x86_avx512_mask_vcvtps2ph_512, {},
                           {value, ir.getInt32(kTowardsZero), llvm::Constant::getNullValue(halves),
                            ir.getInt16(0xFFFF)}),
        code.i32);
  if (code.cpu.family == Cpu::Family::Avx2)
    return ir.CreateZExt(ir.CreateIntrinsic(llvm::Intrinsic::x86_vcvtps2ph_256, {},
                                            {value, ir.getInt32(kTowardsZero)}),
                         code.i32);
  Value *const bits = ir.CreateBitCast(value, code.i32);
  Value *const sign = ir.CreateAnd(ir.CreateLShr(bits, code.splat(16)), code.splat(0x8000));
  Value *const magnitude = ir.CreateAnd(bits, code.splat(0x7FFFFFFF));
  const auto below = [&](int limit) { return ir.CreateICmpSLT(magnitude, code.splat(limit)); };
  Value *half =
      ir.CreateLShr(ir.CreateSub(magnitude, code.splat((127 - 15) << 23)), code.splat(13));
  half = code.select(below(0x47800000), half, code.splat(0x7BFF)); // 65536
  // Values below the least normal number, 2^-14, are in units of 2^-24.
  Value *const units = ir.CreateFMul(ir.CreateBitCast(magnitude, code.f32), code.splat(0x1p24f));
  half = code.select(below(0x38800000),
                     code.toInt(code.select(below(0x38800000), units, code.splat(0.0f))), half);
  half = code.select(below(0x7F800000), half, code.splat(0x7C00));
  half = code.select(below(0x7F800001), half, code.splat(0x7E00));
  return ir.CreateOr(half, sign);
}

/// Converts one component to integers of the layout's width.
Value *storedBits(Code &code, abi::Layout layout, Value *value) {
  llvm::IRBuilder<> &ir = code.ir;
  const PixelType type = pixelType(code, layout);
  auto *const integers = llvm::FixedVectorType::get(type.type, unsigned(code.lanes));
  if (abi::isHalf(layout))
    return ir.CreateTrunc(halfBits(code, value), integers);
  if (abi::isFloat(layout))
    return ir.CreateBitCast(value, integers);
  return ir.CreateTrunc(normalizedBits(code, value, int(type.type->getScalarSizeInBits())),
                        integers);
}

/// Packs a colour into the word of a packed layout.
Value *packedWord(Code &code, const abi::Format &format, const Vec &color) {
  Value *word = nullptr;
  for (int k = 0; k < abi::componentsOf(format.layout); ++k) {
    const abi::BitField field = abi::bitsOf(format.layout, k);
    const int component = componentOf(format, k);
    Value *const value = component < 0 ? nullptr : color[std::size_t(component)];
    Value *bits = code.splat(component < 0 ? (1 << field.bits) - 1 : 0);
    if (value)
      bits = normalizedBits(code, value, field.bits);
    bits = code.ir.CreateShl(bits, code.splat(field.shift));
    word = word ? code.ir.CreateOr(word, bits) : bits;
  }
  auto *const type = pixelType(code, format.layout).type;
  return code.ir.CreateZExtOrTrunc(word, llvm::FixedVectorType::get(type, unsigned(code.lanes)));
}

/// Interleaves vectors: a0 b0 .. a1 b1 ..
Value *interleaved(Code &code, const std::vector<Value *> &parts) {
  if (parts.size() == 1)
    return parts[0];
  const int count = int(parts.size()), lanes = code.lanes;
  const auto joined = [&](Value *a, Value *b, int length) {
    std::vector<int> all(std::size_t(2 * length), 0);
    std::iota(all.begin(), all.end(), 0);
    return code.ir.CreateShuffleVector(a, b, all);
  };
  Value *all = joined(parts[0], parts[1], lanes);
  if (count == 4)
    all = joined(all, joined(parts[2], parts[3], lanes), 2 * lanes);
  std::vector<int> indices;
  indices.reserve(std::size_t(count * lanes));
  for (int i = 0; i < count * lanes; ++i)
    indices.push_back(i % count * lanes + i / count);
  return code.ir.CreateShuffleVector(all, indices);
}
} // namespace

PixelType pixelType(Code &code, abi::Layout layout) {
  const int bytes = abi::bytesOf(layout);
  if (bytes == 0 || abi::isDepth(layout))
    return {};
  // Four bytes are one word, as are the components of a packed layout.
  const int parts =
      abi::isPacked(layout) || layout == abi::Layout::U8x4 ? 1 : abi::componentsOf(layout);
  return {code.ir.getIntNTy(unsigned(8 * bytes / parts)), parts};
}

bool isDrawable(abi::Layout layout) { return abi::componentsOf(layout) > 0; }

int componentOf(const abi::Format &format, int k) {
  for (int c = 0; c < 4; ++c)
    if (format.swizzle[std::size_t(c)] == abi::From(k))
      return c;
  return -1;
}

Value *packPixels(Code &code, const abi::Format &format, const Vec &color) {
  if (format.layout == abi::Layout::U8x4)
    return packBytes(code, format, color);
  if (abi::isPacked(format.layout))
    return packedWord(code, format, color);
  std::vector<Value *> parts;
  for (int k = 0; k < pixelType(code, format.layout).parts; ++k) {
    const int component = componentOf(format, k);
    Value *const value = component < 0 ? code.splat(1.0f) : color[std::size_t(component)];
    parts.push_back(storedBits(code, format.layout, value ? value : code.splat(0.0f)));
  }
  return interleaved(code, parts);
}

Value *keptBits(Code &code, const abi::Format &format, unsigned writeMask) {
  const PixelType type = pixelType(code, format.layout);
  const bool inWord = format.layout == abi::Layout::U8x4 || abi::isPacked(format.layout);
  const int stored = inWord ? abi::componentsOf(format.layout) : type.parts;
  std::vector<llvm::Constant *> kept;
  std::uint32_t word = 0;
  bool any = false;
  for (int k = 0; k < stored; ++k) {
    const int c = componentOf(format, k);
    const bool keeps = c >= 0 && !(writeMask >> c & 1);
    const abi::BitField field =
        abi::isPacked(format.layout) ? abi::bitsOf(format.layout, k) : abi::BitField{8 * k, 8};
    any |= keeps;
    word |= keeps && inWord ? ((1u << field.bits) - 1) << field.shift : 0;
    kept.push_back(keeps ? llvm::Constant::getAllOnesValue(type.type)
                         : llvm::Constant::getNullValue(type.type));
  }
  if (!any)
    return nullptr;
  if (inWord)
    return llvm::ConstantVector::getSplat(llvm::ElementCount::getFixed(unsigned(code.lanes)),
                                          llvm::ConstantInt::get(type.type, word));
  llvm::SmallVector<llvm::Constant *, 64> all;
  for (int i = 0; i < code.lanes * stored; ++i)
    all.push_back(kept[std::size_t(i % stored)]);
  return llvm::ConstantVector::get(all);
}

} // namespace arbiter::fp::llvm_back
