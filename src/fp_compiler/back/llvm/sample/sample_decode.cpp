#include "fp_compiler/back/llvm/sample/sample_parts.h"

#include <iterator>

#include <llvm/IR/Intrinsics.h>

#include "fp_compiler/back/llvm/math/math.h"

namespace arbiter::fp::llvm_back {
namespace {

using abi::From;
using abi::Layout;

/// Returns bits [shift, shift + bits) of a word as an integer.
Value *bitsOf(Code &code, Value *word, int shift, int bits) {
  Value *value = word;
  if (shift > 0)
    value = code.ir.CreateLShr(value, code.splat(shift));
  if (shift + bits < 32)
    value = code.ir.CreateAnd(value, code.splat((1 << bits) - 1));
  return value;
}

Value *normalized(Code &code, Value *word, int shift, int bits) {
  // The product with the rounded reciprocal gives exactly 0 and 1.
  const float scale = 1.0f / float((1 << bits) - 1);
  // A number in the low bits of a float's mantissa needs no conversion. (2^23 + n) * s - 2^23 * s
  // is rounded once, to the same value as n * s. AVX-512 inserts the bits in one operation.
  const int room = shift + bits <= 23 ? shift : 8;
  if (code.cpu.family == Cpu::Family::Avx512 && shift + bits < 32 && room + bits <= 23) {
    Value *const moved = room < shift ? code.ir.CreateLShr(word, code.splat(shift - room)) : word;
    Value *const kept = code.ir.CreateAnd(moved, code.splat(((1 << bits) - 1) << room));
    Value *const number =
        code.ir.CreateBitCast(code.ir.CreateOr(kept, code.splat(0x4B000000)), code.f32);
    const float step = scale / float(1 << room);
    return code.ir.CreateIntrinsic(llvm::Intrinsic::fma, {code.f32},
                                   {number, code.splat(step), code.splat(-step * 0x1p23f)});
  }
  return code.ir.CreateFMul(code.toFloat(bitsOf(code, word, shift, bits)), code.splat(scale));
}

bool convertsHalf(const Cpu &cpu) {
  return cpu.family == Cpu::Family::Avx512 || cpu.family == Cpu::Family::Avx2;
}

/// Converts the half float in the low 16 bits of `half`. All other bits must be zero.
Value *halfToFloat(Code &code, Value *half) {
  const unsigned lanes = unsigned(code.lanes);
  if (convertsHalf(code.cpu)) {
    Value *const narrow =
        code.ir.CreateTrunc(half, llvm::FixedVectorType::get(code.ir.getInt16Ty(), lanes));
    Value *const real =
        code.ir.CreateBitCast(narrow, llvm::FixedVectorType::get(code.ir.getHalfTy(), lanes));
    return code.ir.CreateFPExt(real, code.f32);
  }
  // Without an instruction for it, LLVM would call a function for each lane.
  Value *const magnitude = code.ir.CreateAnd(half, code.splat(0x7FFF));
  Value *const sign =
      code.ir.CreateShl(code.ir.CreateAnd(half, code.splat(0x8000)), code.splat(16));
  Value *const shifted = code.ir.CreateShl(magnitude, code.splat(13));
  Value *const normal = code.ir.CreateAdd(shifted, code.splat((127 - 15) << 23));
  Value *const special = code.ir.CreateAdd(shifted, code.splat((255 - 31) << 23));
  // A denormal is its 10 bits as an integer, in units of 2^-24.
  Value *const tiny = code.ir.CreateBitCast(
      code.ir.CreateFMul(code.toFloat(magnitude), code.splat(0x1p-24f)), code.i32);
  Value *bits = code.select(code.ir.CreateICmpSLT(magnitude, code.splat(0x0400)), tiny, normal);
  bits = code.select(code.ir.CreateICmpSGE(magnitude, code.splat(0x7C00)), special, bits);
  return code.ir.CreateBitCast(code.ir.CreateOr(bits, sign), code.f32);
}

/// Returns the position of a stored component in a texel. Depth layouts have one component.
abi::BitField fieldOf(Layout layout, int component) {
  if (abi::isPacked(layout))
    return abi::bitsOf(layout, component);
  if (layout == Layout::Depth24Stencil8)
    return {8, 24};
  const int components = abi::isDepth(layout) ? 1 : abi::componentsOf(layout);
  const int bits = 8 * abi::bytesOf(layout) / components;
  return {component * bits, bits};
}

/// Decodes an sRGB value that is a multiple of 1/255 (OpenGL 2.1, 3.8.15). The error is within 2e-6
/// for all of them, and 0 and 1 are exact.
Value *linearOf(Code &code, Value *encoded) {
  // ((c + 0.055) / 1.055)^2.4 is approximated as 1 + (c - 1) * q(c), where q is a minimax
  // polynomial.
  constexpr float kQ[] = {0.0585065502f, -0.206142312f, 0.319880653f, -0.330177785f,
                          0.46924716f,   0.964567677f,  0.999126239f};
  Value *q = code.splat(kQ[0]);
  for (std::size_t i = 1; i < std::size(kQ); ++i)
    q = multiplyAdd(code, q, encoded, code.splat(kQ[i]));
  Value *const power =
      multiplyAdd(code, q, code.ir.CreateFSub(encoded, code.splat(1.0f)), code.splat(1.0f));
  Value *const low = code.ir.CreateFMul(encoded, code.splat(1.0f / 12.92f));
  return code.select(code.ir.CreateFCmpOLE(encoded, code.splat(0.04045f)), low, power);
}

/// Converts all 32 bits to a number in [0,1]. Bits that a float cannot hold are rounded once.
Value *normalized32(Code &code, Value *word) {
  Value *const number = code.ir.CreateUIToFP(word, code.f32);
  return code.ir.CreateFMul(number, code.splat(1.0f / 4294967295.0f));
}

Value *storedComponent(Code &code, Layout layout, const Words &words, int component) {
  const abi::BitField field = fieldOf(layout, component);
  Value *const word = words[std::size_t(field.shift / 32)];
  const int shift = field.shift % 32, bits = field.bits;
  switch (layout) {
  case Layout::U8x1:
  case Layout::U8x2:
  case Layout::U8x4:
  case Layout::U16x1:
  case Layout::U16x2:
  case Layout::U16x4:
  case Layout::Bits565:
  case Layout::Bits4444:
  case Layout::Bits5551:
  case Layout::Bits1010102:
  case Layout::Depth16:
  case Layout::Depth24Stencil8:
    return normalized(code, word, shift, bits);
  case Layout::F16x1:
  case Layout::F16x2:
  case Layout::F16x4:
    return halfToFloat(code, bitsOf(code, word, shift, bits));
  case Layout::F32x1:
  case Layout::F32x2:
  case Layout::F32x4:
  case Layout::Depth32F:
    return code.ir.CreateBitCast(word, code.f32);
  case Layout::Depth32:
    return normalized32(code, word);
  case Layout::None:
    break;
  }
  return code.splat(0.0f);
}

} // namespace

unsigned wordsNeeded(const abi::Format &format, unsigned needed) {
  unsigned words = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (needed >> i & 1 && format.swizzle[i] <= From::C3)
      words |= 1u << fieldOf(format.layout, int(format.swizzle[i])).shift / 32;
  return words;
}

Vec decodeWords(Code &code, const abi::Format &format, const Words &words, unsigned needed) {
  Vec stored = {}, result = {};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(needed >> i & 1))
      continue;
    const From from = format.swizzle[i];
    if (from == From::Zero || from == From::One) {
      result[i] = code.splat(from == From::One ? 1.0f : 0.0f);
      continue;
    }
    Value *&component = stored[std::size_t(from)];
    const bool made = !component;
    if (made)
      component = storedComponent(code, format.layout, words, int(from));
    if (made && (format.srgb >> int(from) & 1) != 0)
      component = linearOf(code, component);
    result[i] = component;
  }
  return result;
}

Vec decode(Code &code, const abi::Format &format, Value *raw, unsigned needed) {
  const int bytes = abi::bytesOf(format.layout);
  Words words = {};
  if (bytes <= 4) {
    words[0] =
        bytes == 4 ? code.ir.CreateBitCast(raw, code.i32) : code.ir.CreateZExt(raw, code.i32);
    return decodeWords(code, format, words, needed);
  }
  const int count = bytes / 4;
  Value *const all = code.ir.CreateBitCast(
      raw, llvm::FixedVectorType::get(code.ir.getInt32Ty(), unsigned(code.lanes * count)));
  const unsigned used = wordsNeeded(format, needed);
  for (int word = 0; word < count; ++word) {
    if (!(used >> word & 1))
      continue;
    llvm::SmallVector<int, 16> from;
    for (int lane = 0; lane < code.lanes; ++lane)
      from.push_back(lane * count + word);
    words[std::size_t(word)] = code.ir.CreateShuffleVector(all, from);
  }
  return decodeWords(code, format, words, needed);
}

} // namespace arbiter::fp::llvm_back
