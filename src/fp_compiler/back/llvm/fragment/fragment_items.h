#pragma once
#include "fp_compiler/back/llvm/pixel/interpolate.h"

/// The items of a fragment function: spans, blocks or packed pixels.
namespace arbiter::fp::llvm_back {

/// A span, a block or a vector of packed pixels; `extent` is a count, a mask or the pixels.
struct Item {
  Value *x, *y, *extent;
};

/// Returns the function's span or block of that index.
[[nodiscard]] Item itemAt(Code &code, llvm::Function *function, Value *number);
/// Returns the function's packed pixels from that index on, relative to the base of the columns.
/// Tells \p interpolator their columns.
[[nodiscard]] Item packedItem(Code &code, llvm::Function *function, Value *number,
                              Interpolator &interpolator);
/// Returns the byte at \p offset of each lane's abi::Pixel.
[[nodiscard]] Value *byteOf(Code &code, Value *pixels, std::size_t offset);

} // namespace arbiter::fp::llvm_back
