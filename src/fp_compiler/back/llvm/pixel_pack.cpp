#include <llvm/IR/IntrinsicsX86.h>

#include "fp_compiler/back/llvm/pixel.h"
#include "fp_compiler/back/llvm/pixel_range.h"

namespace arbiter::fp::llvm_back {

namespace {
/// The component that byte \p k of a pixel holds; -1 for none.
int componentOf(const abi::Format &format, int k) {
  for (int c = 0; c < 4; ++c)
    if (format.swizzle[std::size_t(c)] == abi::From(k))
      return c;
  return -1;
}

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
} // namespace

Value *packUnorm8(Code &code, const abi::Format &format, const Vec &color) {
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

} // namespace arbiter::fp::llvm_back
