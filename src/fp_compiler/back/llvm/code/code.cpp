#include "fp_compiler/back/llvm/code/code.h"

#include <llvm/IR/Intrinsics.h>
#if defined(__x86_64__) || defined(__i386__)
#include <llvm/IR/IntrinsicsX86.h>
#endif

namespace arbiter::fp::llvm_back {

Code::Code(llvm::IRBuilder<> &builder, const Cpu &target)
    : ir(builder), cpu(target), lanes(target.lanes()),
      f32(llvm::FixedVectorType::get(builder.getFloatTy(), unsigned(lanes))),
      i32(llvm::FixedVectorType::get(builder.getInt32Ty(), unsigned(lanes))),
      i1(llvm::FixedVectorType::get(builder.getInt1Ty(), unsigned(lanes))) {}

Value *Code::splat(float value) { return llvm::ConstantFP::get(f32, double(value)); }

Value *Code::splat(int value) { return llvm::ConstantInt::getSigned(i32, value); }

Value *Code::splat(Value *scalar) { return ir.CreateVectorSplat(unsigned(lanes), scalar); }

Value *Code::iota() {
  llvm::SmallVector<llvm::Constant *, 16> values;
  for (int i = 0; i < lanes; ++i)
    values.push_back(ir.getInt32(unsigned(i)));
  return llvm::ConstantVector::get(values);
}

Value *Code::min(Value *a, Value *b) { return ir.CreateSelect(ir.CreateFCmpOLT(a, b), a, b); }

Value *Code::max(Value *a, Value *b) { return ir.CreateSelect(ir.CreateFCmpOGT(a, b), a, b); }

Value *Code::floor(Value *a) { return ir.CreateUnaryIntrinsic(llvm::Intrinsic::floor, a); }

Value *Code::toInt(Value *a) {
  // An out-of-range fptosi is poison; freeze turns it into some fixed value.
  return ir.CreateFreeze(ir.CreateFPToSI(a, i32));
}

Value *Code::toFloat(Value *a) { return ir.CreateSIToFP(a, f32); }

Value *Code::saturate(Value *a) { return min(max(a, splat(0.0f)), splat(1.0f)); }

void Code::prefetch(Value *pointer, unsigned bytes, bool isWritten) {
  constexpr unsigned kLine = 64;
  for (unsigned at = 0; at < bytes; at += kLine)
    ir.CreateIntrinsic(llvm::Intrinsic::prefetch, {ir.getPtrTy()},
                       {ir.CreateConstGEP1_32(ir.getInt8Ty(), pointer, at),
                        ir.getInt32(isWritten ? 1 : 0), ir.getInt32(3), ir.getInt32(1)});
}

Value *Code::lookUp(Value *table, Value *index) {
#if defined(__x86_64__) || defined(__i386__)
  const llvm::Align align(std::uint64_t(lanes) * 4);
  if (cpu.family == Cpu::Family::Avx512)
    return ir.CreateIntrinsic(llvm::Intrinsic::x86_avx512_permvar_si_512, {},
                              {ir.CreateAlignedLoad(i32, table, align), index});
  if (cpu.family == Cpu::Family::Avx2)
    return ir.CreateIntrinsic(llvm::Intrinsic::x86_avx2_permd, {},
                              {ir.CreateAlignedLoad(i32, table, align), index});
#endif
  Value *const element = ir.CreateAnd(index, splat(lanes - 1));
  Value *const pointers = ir.CreateGEP(ir.getInt32Ty(), table, element);
  return ir.CreateMaskedGather(i32, pointers, llvm::Align(4), llvm::Constant::getAllOnesValue(i1),
                               llvm::Constant::getNullValue(i32));
}

Value *Code::field(llvm::Type *type, Value *pointer, std::size_t offset) {
  return ir.CreateLoad(type, ir.CreateConstInBoundsGEP1_64(ir.getInt8Ty(), pointer, offset));
}

} // namespace arbiter::fp::llvm_back
