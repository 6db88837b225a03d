#include "fp_compiler/back/llvm/sample_parts.h"

#include <llvm/IR/Intrinsics.h>

namespace arbiter::fp::llvm_back {
namespace {

int dimensionsOf(abi::Dimension dimension) {
  switch (dimension) {
  case abi::Dimension::Tex1D:
    return 1;
  case abi::Dimension::Tex2D:
  case abi::Dimension::Cube:
  case abi::Dimension::Rect:
    return 2;
  case abi::Dimension::Tex3D:
    return 3;
  }
  llvm_unreachable("a dimension");
}

/// An incomplete texture (3.11.6 of ARB_fragment_program): (0, 0, 0, 1).
Vec incomplete(Code &code, unsigned needed) {
  Vec rgba = {};
  for (std::size_t i = 0; i < 4; ++i)
    if (needed >> i & 1)
      rgba[i] = code.splat(i == 3 ? 1.0f : 0.0f);
  return rgba;
}

/// Texels that follow each other from `pointer` on.
Texel consecutive(Code &code, const abi::Format &format, Value *pointer, unsigned needed) {
  const unsigned bits = unsigned(abi::bytesOf(format.layout)) * 8;
  Value *const raw = code.ir.CreateAlignedLoad(
      llvm::FixedVectorType::get(code.ir.getIntNTy(bits), unsigned(code.lanes)), pointer,
      llvm::Align(1));
  Texel texel;
  texel.rgba = decode(code, format, raw, needed);
  if (format.layout == abi::Layout::U8x4)
    texel.packed = raw;
  return texel;
}

} // namespace

Value *constantField(Code &code, llvm::Type *type, Value *pointer, std::size_t offset) {
  auto *const load = code.ir.CreateLoad(
      type, code.ir.CreateConstInBoundsGEP1_64(code.ir.getInt8Ty(), pointer, offset));
  load->setMetadata(llvm::LLVMContext::MD_invariant_load,
                    llvm::MDNode::get(code.context(), llvm::None));
  return load;
}

Value *anyLane(Code &code, Value *mask) { return code.ir.CreateOrReduce(mask); }
Value *allLanes(Code &code, Value *mask) { return code.ir.CreateAndReduce(mask); }

ImageCode loadImage(Code &code, const abi::Format &format, Value *view, Value *image,
                    int dimensions) {
  llvm::Type *const i32 = code.ir.getInt32Ty(), *const i64 = code.ir.getInt64Ty();
  Value *const levels =
      constantField(code, code.ir.getInt8PtrTy(), view, offsetof(abi::TextureView, levels));
  Value *const at = code.ir.CreateMul(code.ir.CreateZExt(image, i64),
                                      code.ir.getInt64(sizeof(abi::TextureLevel)));
  Value *const level = code.ir.CreateGEP(code.ir.getInt8Ty(), levels, at);
  // Sizes of texels are powers of two, strides multiples of them.
  const unsigned shift = llvm::Log2_32(unsigned(abi::bytesOf(format.layout)));
  const auto stride = [&](std::size_t offset) {
    return code.ir.CreateTrunc(code.ir.CreateAShr(constantField(code, i64, level, offset), shift),
                               i32);
  };
  ImageCode result;
  result.format = format;
  result.base =
      constantField(code, code.ir.getInt8PtrTy(), level, offsetof(abi::TextureLevel, base));
  result.size[0] = constantField(code, i32, level, offsetof(abi::TextureLevel, width));
  if (dimensions > 1) {
    result.size[1] = constantField(code, i32, level, offsetof(abi::TextureLevel, height));
    result.stride[0] = stride(offsetof(abi::TextureLevel, rowStride));
  }
  if (dimensions > 2) {
    result.size[2] = constantField(code, i32, level, offsetof(abi::TextureLevel, depth));
    result.stride[1] = stride(offsetof(abi::TextureLevel, sliceStride));
  }
  return result;
}

Texel sample(Code &code, const abi::SamplerKey &key, abi::Lanes lanes, Value *view,
             const SampleAt &at, unsigned needed) {
  Texel texel;
  if (key.format.layout == abi::Layout::None) {
    texel.rgba = incomplete(code, needed);
    return texel;
  }
  if (at.texels)
    return consecutive(code, key.format, at.texels, needed);
  Lookup lookup{key, lanes, view, {}};
  lookup.dimensions = dimensionsOf(key.dimension);
  lookup.coordinate = at.coordinate;
  lookup.needed = needed;
  lookup.image = loadImage(code, key.format, view, code.ir.getInt32(0), lookup.dimensions);
  if (key.magnify == abi::Filter::Nearest)
    return filterNearest(code, lookup);
  texel.rgba = filterLinear(code, lookup);
  return texel;
}

} // namespace arbiter::fp::llvm_back
