#include "fp_compiler/back/llvm/fragment/fragment_spans.h"

namespace arbiter::fp::llvm_back {

SpanGroup::SpanGroup(Code &code, const Places &places, Value *items, Value *first, Value *count)
    : m_code(code), m_places(places) {
  static_assert(sizeof(abi::Span) == sizeof(std::uint64_t) && offsetof(abi::Span, x) == 0 &&
                offsetof(abi::Span, y) == 2 && offsetof(abi::Span, count) == 4);
  llvm::IRBuilder<> &ir = code.ir;
  writeIn(code, places.group, [&] {
    auto *const words = llvm::FixedVectorType::get(ir.getInt64Ty(), size());
    auto *const numbers = llvm::FixedVectorType::get(ir.getInt32Ty(), size());
    // Lanes after the last span get empty spans.
    llvm::SmallVector<llvm::Constant *, 8> lanes;
    for (unsigned i = 0; i < size(); ++i)
      lanes.push_back(ir.getInt32(i));
    Value *const there = ir.CreateICmpULT(llvm::ConstantVector::get(lanes),
                                          ir.CreateVectorSplat(size(), ir.CreateSub(count, first)));
    Value *const at = ir.CreateGEP(ir.getInt64Ty(), items, ir.CreateZExt(first, ir.getInt64Ty()));
    Value *const spans = ir.CreateMaskedLoad(words, at, llvm::Align(alignof(abi::Span)), there,
                                             llvm::Constant::getNullValue(words));
    const auto signedHalf = [&](unsigned shift) {
      return ir.CreateTrunc(ir.CreateAShr(ir.CreateShl(spans, 48 - shift), std::uint64_t(48)),
                            numbers);
    };
    m_x = signedHalf(0);
    m_y = signedHalf(16);
    m_count = ir.CreateTrunc(ir.CreateAnd(ir.CreateLShr(spans, 32), 0xFFFF), numbers);
  });
}

Value *SpanGroup::inLanes(Value *value) const {
  if (value->getType()->isVectorTy())
    return value;
  if (auto *const constant = llvm::dyn_cast<llvm::Constant>(value))
    return llvm::ConstantVector::getSplat(llvm::ElementCount::getFixed(size()), constant);
  return writeIn(m_code, m_places.entry,
                 [&] { return m_code.ir.CreateVectorSplat(size(), value); });
}

Value *SpanGroup::ofItem(Value *vector, Value *number) const {
  llvm::IRBuilder<> &ir = m_code.ir;
  const bool isTruth = vector->getType()->getScalarType()->isIntegerTy(1);
  auto *const type = llvm::FixedVectorType::get(
      isTruth ? ir.getInt32Ty() : vector->getType()->getScalarType(), size());
  llvm::AllocaInst *const memory =
      writeIn(m_code, m_places.entry, [&] { return ir.CreateAlloca(type); });
  memory->setAlignment(llvm::Align(64));
  writeIn(m_code, m_places.group, [&] {
    ir.CreateAlignedStore(isTruth ? ir.CreateSExt(vector, type) : vector, memory, llvm::Align(64));
  });
  return writeIn(m_code, m_places.item, [&] {
    llvm::Type *const element = type->getElementType();
    Value *const value = ir.CreateLoad(element, ir.CreateGEP(element, memory, number));
    return isTruth ? ir.CreateIsNotNull(value) : value;
  });
}

} // namespace arbiter::fp::llvm_back
