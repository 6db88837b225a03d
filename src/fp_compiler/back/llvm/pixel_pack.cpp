#include "fp_compiler/back/llvm/pixel_pack.h"

#include <numeric>
#include <vector>

#include <llvm/IR/IntrinsicsX86.h>

#include "fp_compiler/back/llvm/pixel_range.h"

namespace arbiter::fp::llvm_back {

namespace {
/// Numbers that a sum with 2^23 rounds to integers, in the lowest byte of each lane.
Value *byteBySum(Code &code, Value *value) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *const scaled = ir.CreateFMul(code.saturate(value), code.splat(255.0f));
  Value *const bits = ir.CreateBitCast(ir.CreateFAdd(scaled, code.splat(0x1p23f)), code.i32);
  return ir.CreateAnd(bits, code.splat(255));
}

/// x86 packs integers with saturation: what is below 0 or above 255 needs no clamp, only what does
/// not fit 32 bits. A conversion gives the least integer for that, and for NaN.
class X86Packer {
public:
  explicit X86Packer(Code &code) : m_code(code) {}

  Value *integers(Value *value) {
    llvm::IRBuilder<> &ir = m_code.ir;
    Value *scaled = ir.CreateFMul(value, m_code.splat(255.0f));
    const Range range = rangeOf(value);
    if (!(range.high <= 0x1p22f)) {
      // The order keeps NaN.
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

  /// Per 128 bits: four pixels' bytes, component by component, brought together by pixel.
  Value *pack(const std::array<Value *, 4> &bytes) {
    llvm::IRBuilder<> &ir = m_code.ir;
    Value *const low = call(kPackWords, bytes[0], bytes[1]);
    Value *const high = call(kPackWords, bytes[2], bytes[3]);
    Value *const planes = call(kPackBytes, low, high);
    std::vector<int> indices;
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
/// U8x4, as one i32 a pixel.
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

/// One stored component, as integers of the layout's width.
Value *storedBits(Code &code, abi::Layout layout, Value *value) {
  llvm::IRBuilder<> &ir = code.ir;
  const PixelType type = pixelType(code, layout);
  auto *const integers = llvm::FixedVectorType::get(type.type, unsigned(code.lanes));
  if (isFloat(layout))
    return ir.CreateBitCast(value, integers);
  const bool isByte = type.type->isIntegerTy(8);
  // Below 2^23 adding a half and cutting off rounds to nearest.
  Value *const scaled = ir.CreateFMul(code.saturate(value), code.splat(isByte ? 255.0f : 65535.0f));
  return ir.CreateTrunc(code.toInt(ir.CreateFAdd(scaled, code.splat(0.5f))), integers);
}

/// a0 b0 .. a1 b1 ..
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
  for (int i = 0; i < count * lanes; ++i)
    indices.push_back(i % count * lanes + i / count);
  return code.ir.CreateShuffleVector(all, indices);
}
} // namespace

PixelType pixelType(Code &code, abi::Layout layout) {
  llvm::IRBuilder<> &ir = code.ir;
  switch (layout) {
  case abi::Layout::U8x1:
    return {ir.getInt8Ty(), 1};
  case abi::Layout::U8x2:
    return {ir.getInt8Ty(), 2};
  case abi::Layout::U8x4:
    return {ir.getInt32Ty(), 1};
  case abi::Layout::U16x4:
    return {ir.getInt16Ty(), 4};
  case abi::Layout::F32x1:
    return {ir.getInt32Ty(), 1};
  case abi::Layout::F32x2:
    return {ir.getInt32Ty(), 2};
  case abi::Layout::F32x4:
    return {ir.getInt32Ty(), 4};
  default:
    return {};
  }
}

bool isFloat(abi::Layout layout) {
  return layout == abi::Layout::F32x1 || layout == abi::Layout::F32x2 ||
         layout == abi::Layout::F32x4;
}

bool isDrawable(abi::Layout layout) {
  return isFloat(layout) || layout == abi::Layout::U8x1 || layout == abi::Layout::U8x2 ||
         layout == abi::Layout::U8x4 || layout == abi::Layout::U16x4;
}

int componentOf(const abi::Format &format, int k) {
  for (int c = 0; c < 4; ++c)
    if (format.swizzle[std::size_t(c)] == abi::From(k))
      return c;
  return -1;
}

Value *packPixels(Code &code, const abi::Format &format, const Vec &color) {
  if (format.layout == abi::Layout::U8x4)
    return packBytes(code, format, color);
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
  const bool bytesInWord = format.layout == abi::Layout::U8x4;
  const int stored = bytesInWord ? 4 : type.parts;
  std::vector<llvm::Constant *> kept;
  std::uint32_t word = 0;
  bool any = false;
  for (int k = 0; k < stored; ++k) {
    const int c = componentOf(format, k);
    const bool keeps = c >= 0 && !(writeMask >> c & 1);
    any |= keeps;
    word |= keeps ? 0xFFu << (8 * k) : 0;
    kept.push_back(keeps ? llvm::Constant::getAllOnesValue(type.type)
                         : llvm::Constant::getNullValue(type.type));
  }
  if (!any)
    return nullptr;
  if (bytesInWord)
    return code.splat(int(word));
  llvm::SmallVector<llvm::Constant *, 64> all;
  for (int i = 0; i < code.lanes * stored; ++i)
    all.push_back(kept[std::size_t(i % stored)]);
  return llvm::ConstantVector::get(all);
}

} // namespace arbiter::fp::llvm_back
