#pragma once
#include "fp_compiler/back/llvm/code/code.h"

/// Colours as the bits of a buffer's pixels.
namespace arbiter::fp::llvm_back {

/// A pixel in memory: `parts` integers of \p type. A vector of pixels has lanes * parts of them.
struct PixelType {
  llvm::Type *type = nullptr;
  int parts = 1;
};
[[nodiscard]] PixelType pixelType(Code &code, abi::Layout layout);
/// Layouts of colour buffers.
[[nodiscard]] bool isDrawable(abi::Layout layout);

/// The component that stored component \p k holds; -1 for none.
[[nodiscard]] int componentOf(const abi::Format &format, int k);

/// Values beyond [0,1] are clamped for normalised layouts, NaN gives 0, and c/255 gives c. A stored
/// component that holds none is 1; a null component is 0.
[[nodiscard]] Value *packPixels(Code &code, const abi::Format &format, const Vec &color);

/// Of a vector of pixels: bits set where a write mask keeps what was there; null if it keeps none.
[[nodiscard]] Value *keptBits(Code &code, const abi::Format &format, unsigned writeMask);

} // namespace arbiter::fp::llvm_back
