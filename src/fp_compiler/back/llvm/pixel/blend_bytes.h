#pragma once
#include "fp_compiler/back/llvm/pixel/pixel_pack.h"

/// Blending of buffers of four bytes a pixel, in bytes.
namespace arbiter::fp::llvm_back {

/// Returns the pixels that a blend makes of `source` and `dest`. Both are one i32 a lane in the
/// format's order, and so is the result. Each factor is a byte, and so is each product: the number
/// of 255ths that is nearest to it. So llvmpipe has it, and pictures of many faint layers are the
/// same whoever draws them.
/// \param sourceAlpha the place of alpha among the bytes of `source`, which has one even where
///                    the format has none
/// \param constant the blend colour
[[nodiscard]] Value *blendBytes(Code &code, const abi::Format &format, const abi::BlendKey &key,
                                Value *source, int sourceAlpha, Value *dest, const Vec &constant);

} // namespace arbiter::fp::llvm_back
