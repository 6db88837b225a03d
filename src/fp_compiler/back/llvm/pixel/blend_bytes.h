#pragma once
#include "fp_compiler/back/llvm/pixel/pixel_pack.h"

/// Blending of buffers with four bytes in each pixel, in byte arithmetic.
namespace arbiter::fp::llvm_back {

/// Returns the result of blending `source` with `dest`. All have one i32 in each lane in the
/// format's order. Factors and products are bytes, rounded to the nearest 255th. llvmpipe does the
/// same, so that images of many faint layers are identical to the host's.
/// \param sourceAlpha the byte of `source` that holds alpha; it has one even if the format does not
/// \param constant the blend colour
[[nodiscard]] Value *blendBytes(Code &code, const abi::Format &format, const abi::BlendKey &key,
                                Value *source, int sourceAlpha, Value *dest, const Vec &constant);

} // namespace arbiter::fp::llvm_back
