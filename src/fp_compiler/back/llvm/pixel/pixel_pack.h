#pragma once
#include "fp_compiler/back/llvm/code/code.h"

/// Conversion of colours to the bits of a buffer's pixels.
namespace arbiter::fp::llvm_back {

/// A pixel in memory: `parts` integers of \p type. A vector of pixels has lanes * parts of them.
struct PixelType {
  llvm::Type *type = nullptr;
  int parts = 1;
};
[[nodiscard]] PixelType pixelType(Code &code, abi::Layout layout);
/// True for layouts of colour buffers.
[[nodiscard]] bool isDrawable(abi::Layout layout);

/// Returns the colour component in stored component \p k; -1 for none.
[[nodiscard]] int componentOf(const abi::Format &format, int k);

/// Returns pixels as stored. Normalised layouts clamp to [0,1], NaN gives 0, and c/255 gives
/// exactly c. A stored component without a colour component is 1; a null component is 0.
[[nodiscard]] Value *packPixels(Code &code, const abi::Format &format, const Vec &color);

/// Returns the bits of a pixel vector that a write mask preserves; null if there are none.
[[nodiscard]] Value *keptBits(Code &code, const abi::Format &format, unsigned writeMask);

} // namespace arbiter::fp::llvm_back
