#pragma once
#include "fp_compiler/back/llvm/pixel/interpolate.h"

/// What a fragment function is called with: spans, blocks or packed pixels.
namespace arbiter::fp::llvm_back {

/// A span, a block or a vector of packed pixels; `extent` is a count, a mask or the pixels.
struct Item {
  Value *x, *y, *extent;
};

/// The function's span or block of that number.
[[nodiscard]] Item itemAt(Code &code, llvm::Function *function, Value *number);
/// The function's packed pixels from that number on, whose places count from the columns' base.
/// Says to \p interpolator which columns they are of.
[[nodiscard]] Item packedItem(Code &code, llvm::Function *function, Value *number,
                              Interpolator &interpolator);
/// Of each lane's abi::Pixel, from the byte at \p offset.
[[nodiscard]] Value *byteOf(Code &code, Value *pixels, std::size_t offset);

} // namespace arbiter::fp::llvm_back
