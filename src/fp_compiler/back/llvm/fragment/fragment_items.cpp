#include "fp_compiler/back/llvm/fragment/fragment_items.h"

namespace arbiter::fp::llvm_back {

namespace {
Value *itemPointer(Code &code, llvm::Function *function, Value *number, std::size_t bytes) {
  Value *const offset =
      code.ir.CreateMul(code.ir.CreateZExt(number, code.ir.getInt64Ty()), code.ir.getInt64(bytes));
  return code.ir.CreateGEP(code.ir.getInt8Ty(), function->getArg(2), offset);
}
} // namespace

Item itemAt(Code &code, llvm::Function *function, Value *number) {
  static_assert(sizeof(abi::Span) == sizeof(abi::Block));
  llvm::IRBuilder<> &ir = code.ir;
  Value *const pointer = itemPointer(code, function, number, sizeof(abi::Span));
  const auto half = [&](std::size_t at) { return code.field(ir.getInt16Ty(), pointer, at); };
  return {ir.CreateSExt(half(offsetof(abi::Span, x)), ir.getInt32Ty()),
          ir.CreateSExt(half(offsetof(abi::Span, y)), ir.getInt32Ty()),
          ir.CreateZExt(half(offsetof(abi::Span, count)), ir.getInt32Ty())};
}

Item packedItem(Code &code, llvm::Function *function, Value *number, Interpolator &interpolator) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *const primitives = function->getArg(1);
  Value *const raw =
      ir.CreateAlignedLoad(code.i32, itemPointer(code, function, number, sizeof(abi::Pixel)),
                           llvm::Align(sizeof(abi::Pixel)));
  // This reorders pixels from consecutive quads to the lanes of a block.
  const int width = code.cpu.blockWidth();
  llvm::SmallVector<int, 16> from;
  for (int lane = 0; lane < code.lanes; ++lane) {
    const int x = lane % width, y = lane / width;
    from.push_back((y / 2 * (width / 2) + x / 2) * 4 + y % 2 * 2 + x % 2);
  }
  Value *const pixels = ir.CreateShuffleVector(raw, from);
  interpolator.setColumns(byteOf(code, pixels, offsetof(abi::Pixel, column)));
  return {code.field(ir.getInt32Ty(), primitives, offsetof(abi::PrimitiveColumns, baseX)),
          code.field(ir.getInt32Ty(), primitives, offsetof(abi::PrimitiveColumns, baseY)), pixels};
}

Value *byteOf(Code &code, Value *pixels, std::size_t offset) {
  Value *const shifted = code.ir.CreateLShr(pixels, code.splat(int(8 * offset)));
  return code.ir.CreateAnd(shifted, code.splat(0xFF));
}

} // namespace arbiter::fp::llvm_back
