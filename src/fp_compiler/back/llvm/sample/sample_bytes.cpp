#include "fp_compiler/back/llvm/sample/sample_parts.h"

#include <llvm/IR/IntrinsicsX86.h>

/// The linear filter for texels with 8-bit components, with the host's steps. llvmpipe (Mesa
/// 22.3.6) uses weights of 8 bits, and rounds to a byte in each dimension. Results are the same on
/// every processor and for every way of reading texels. If a texel has all the weight, the result
/// is exactly that texel.
namespace arbiter::fp::llvm_back {
namespace {

using abi::From;

/// Returns (a * b + 2^14) >> 15 in 16-bit lanes.
Value *multiplyHigh(Code &code, Value *a, Value *b) {
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
    Value *const product =
        code.ir.CreateMul(code.ir.CreateSExt(a, words), code.ir.CreateSExt(b, words));
    Value *const rounded = code.ir.CreateAdd(product, llvm::ConstantInt::get(words, 1 << 14));
    return code.ir.CreateTrunc(code.ir.CreateAShr(rounded, 15), a->getType());
  }
  }
  return code.ir.CreateIntrinsic(id, {}, {a, b});
}

llvm::VectorType *halves(Code &code) {
  return llvm::FixedVectorType::get(code.ir.getInt16Ty(), unsigned(code.lanes) * 2);
}

/// Returns a weight in both 16-bit halves, in units of 2^-15.
Value *weightOf(Code &code, Value *weight) {
  llvm::IRBuilder<> &ir = code.ir;
  constexpr int kUp = 15 - kWeightBits;
  Value *const low = ir.CreateShl(weight, code.splat(kUp));
  return ir.CreateBitCast(ir.CreateOr(low, ir.CreateShl(weight, code.splat(16 + kUp))),
                          halves(code));
}

/// Bytes 0 and 2 of a texel, or 1 and 3, as 16-bit numbers; null if neither is needed.
using Bytes = std::array<Value *, 2>;

/// Splits a texel into such pairs of bytes.
/// \param texel its bytes in an i32
Bytes split(Code &code, const Lookup &lookup, Value *texel) {
  llvm::IRBuilder<> &ir = code.ir;
  const unsigned needed = bytesNeeded(lookup.image.format, lookup.needed);
  Bytes bytes = {};
  for (std::size_t odd = 0; odd < 2; ++odd)
    if (needed >> odd & 1) {
      Value *const moved = odd ? ir.CreateLShr(texel, code.splat(8)) : texel;
      bytes[odd] = ir.CreateBitCast(ir.CreateAnd(moved, code.splat(0x00FF00FF)), halves(code));
    }
  return bytes;
}

/// Interpolates between bytes and rounds to bytes.
Bytes between(Code &code, const Bytes &first, const Bytes &second, Value *weight) {
  llvm::IRBuilder<> &ir = code.ir;
  Bytes bytes = {};
  for (std::size_t i = 0; i < 2; ++i)
    if (first[i])
      bytes[i] =
          ir.CreateAdd(first[i], multiplyHigh(code, ir.CreateSub(second[i], first[i]), weight));
  return bytes;
}

/// Filters along x and y, in one slice of a 3D texture.
/// \param y null for one dimension
Bytes filterSlice(Code &code, const Lookup &lookup, const AxisTexels &texels, Value *row0,
                  Value *row1, Value *x, Value *y) {
  const auto rows = fetchFootprint(code, lookup.lanes, lookup.image, texels, row0, row1);
  const auto bytesOf = [&](Value *texel) {
    const abi::Layout layout = lookup.image.format.layout;
    return split(code, lookup, abi::isPacked(layout) ? bytesOfPacked(code, layout, texel) : texel);
  };
  const auto along = [&](const TexelPair &row) {
    return between(code, bytesOf(row.first), bytesOf(row.second), x);
  };
  const Bytes first = along(rows[0]);
  return y ? between(code, first, along(rows[1]), y) : first;
}

/// Converts bytes to the texel's components and to its form in memory.
Texel texelOf(Code &code, const Lookup &lookup, const Bytes &bytes) {
  llvm::IRBuilder<> &ir = code.ir;
  std::array<Value *, 2> words = {};
  for (std::size_t i = 0; i < 2; ++i)
    words[i] = bytes[i] ? ir.CreateBitCast(bytes[i], code.i32) : nullptr;
  Texel texel;
  Vec numbers = {};
  for (std::size_t i = 0; i < 4; ++i) {
    const From from = lookup.image.format.swizzle[i];
    if (!(lookup.needed >> i & 1))
      continue;
    if (from > From::C3) {
      texel.rgba[i] = code.splat(from == From::One ? 1.0f : 0.0f);
      continue;
    }
    const auto at = std::size_t(from);
    if (!numbers[at]) {
      Value *const word = words[at % 2];
      Value *const byte =
          at < 2 ? ir.CreateAnd(word, code.splat(0xFFFF)) : ir.CreateLShr(word, code.splat(16));
      // This is the same product as in decode().
      numbers[at] = ir.CreateFMul(code.toFloat(byte), code.splat(1.0f / 255.0f));
    }
    texel.rgba[i] = numbers[at];
  }
  Value *const upper = words[1] ? ir.CreateShl(words[1], code.splat(8)) : code.splat(0);
  texel.packed = words[0] ? ir.CreateOr(words[0], upper) : upper;
  return texel;
}

} // namespace

unsigned bytesNeeded(const abi::Format &format, unsigned needed) {
  unsigned bytes = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (const From from = format.swizzle[i]; (needed >> i & 1) && from <= From::C3)
      bytes |= 1u << (unsigned(from) % 2);
  return bytes;
}

Value *bytesOfPacked(Code &code, abi::Layout layout, Value *word) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *bytes = nullptr;
  for (int i = 0; i < abi::componentsOf(layout); ++i) {
    const abi::BitField field = abi::bitsOf(layout, i);
    Value *const bits = ir.CreateAnd(ir.CreateLShr(word, code.splat(field.shift)),
                                     code.splat((1 << field.bits) - 1));
    // The bits are repeated from the highest on until the byte is full.
    for (int at = 8 * i + 8 - field.bits; at > 8 * i - field.bits; at -= field.bits) {
      const int below = 8 * i - at; // number of bits that do not fit the byte
      Value *const kept = below > 0 ? ir.CreateLShr(bits, code.splat(below)) : bits;
      Value *const moved = ir.CreateShl(kept, code.splat(below > 0 ? 8 * i : at));
      bytes = bytes ? ir.CreateOr(bytes, moved) : moved;
    }
  }
  return bytes;
}

Texel mixBytes(Code &code, const Lookup &lookup, Value *first, Value *second, Value *fraction) {
  Value *const weight =
      code.toInt(code.ir.CreateFMul(fraction, code.splat(float(1 << kWeightBits))));
  return texelOf(code, lookup,
                 between(code, split(code, lookup, first), split(code, lookup, second),
                         weightOf(code, weight)));
}

Texel filterBytes(Code &code, const Lookup &lookup, const std::array<AxisTexels, 3> &axes) {
  const Steps steps = stepsOf(code, lookup.image, axes, lookup.dimensions);
  Value *const x = weightOf(code, axes[0].weight);
  if (lookup.dimensions == 1)
    return texelOf(code, lookup,
                   filterSlice(code, lookup, axes[0], code.splat(0), nullptr, x, nullptr));
  Value *const y = weightOf(code, axes[1].weight);
  if (lookup.dimensions == 2)
    return texelOf(code, lookup,
                   filterSlice(code, lookup, axes[0], steps[1][0], steps[1][1], x, y));
  std::array<Bytes, 2> slices;
  for (std::size_t z = 0; z < 2; ++z)
    slices[z] = filterSlice(code, lookup, axes[0], code.ir.CreateAdd(steps[1][0], steps[2][z]),
                            code.ir.CreateAdd(steps[1][1], steps[2][z]), x, y);
  return texelOf(code, lookup, between(code, slices[0], slices[1], weightOf(code, axes[2].weight)));
}

} // namespace arbiter::fp::llvm_back
