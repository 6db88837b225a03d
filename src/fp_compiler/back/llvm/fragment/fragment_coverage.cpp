#include "fp_compiler/back/llvm/fragment/fragment_coverage.h"

namespace arbiter::fp::llvm_back {

namespace {
void multiplyAlpha(Code &code, Value *part, FragmentColors &fragment) {
  for (Vec &color : fragment.colors)
    if (color[3])
      color[3] = code.ir.CreateFMul(color[3], part);
}
} // namespace

void applyCoverage(Code &code, abi::Coverage coverage, const Vec &input, FragmentColors &fragment) {
  llvm::IRBuilder<> &ir = code.ir;
  if (coverage == abi::Coverage::Disc) {
    Value *const squares =
        ir.CreateFAdd(ir.CreateFMul(input[0], input[0]), ir.CreateFMul(input[1], input[1]));
    Value *const inside = ir.CreateFCmpOLE(squares, code.splat(1.0f));
    fragment.alive = fragment.alive ? ir.CreateAnd(fragment.alive, inside) : inside;
    Value *const one = code.splat(1.0f);
    Value *const part = ir.CreateFMul(ir.CreateFSub(one, squares), input[2]);
    multiplyAlpha(code, code.select(ir.CreateFCmpOGT(part, one), part, one), fragment);
    return;
  }
  const auto along = [&](Value *from, Value *reach) {
    return code.saturate(
        ir.CreateFSub(reach, ir.CreateUnaryIntrinsic(llvm::Intrinsic::fabs, from)));
  };
  multiplyAlpha(code, ir.CreateFMul(along(input[0], input[2]), along(input[1], input[3])),
                fragment);
}

} // namespace arbiter::fp::llvm_back
