#include "fp_compiler/back/llvm/pixel.h"

namespace arbiter::fp::llvm_back {

Value *packUnorm8(Code &code, const abi::Format &format, const Vec &color) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *pixels = code.splat(0);
  for (int k = 0; k < 4; ++k) {
    int component = -1;
    for (int c = 3; c >= 0; --c)
      if (format.swizzle[std::size_t(c)] == abi::From(k))
        component = c;
    Value *byte = component < 0 ? code.splat(255) : code.splat(0);
    if (component >= 0 && color[std::size_t(component)]) {
      // The sum's unit of the last place is 1, so it rounds to nearest, and its lowest byte is the
      // number.
      Value *const scaled =
          ir.CreateFMul(code.saturate(color[std::size_t(component)]), code.splat(255.0f));
      Value *const bits = ir.CreateBitCast(ir.CreateFAdd(scaled, code.splat(0x1p23f)), code.i32);
      byte = ir.CreateAnd(bits, code.splat(255));
    }
    pixels = ir.CreateOr(pixels, ir.CreateShl(byte, code.splat(8 * k)));
  }
  return pixels;
}

} // namespace arbiter::fp::llvm_back
