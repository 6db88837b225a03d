#include "fp_compiler/back/llvm/pixel/pixel_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/IntrinsicsX86.h>
#include <llvm/IR/PatternMatch.h>

namespace arbiter::fp::llvm_back {

namespace {
using namespace llvm::PatternMatch;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr Range kUnknown = {-kInfinity, kInfinity, true};
constexpr int kDepth = 12; ///< maximum depth of the search through instructions

Range rangeAt(const Value *value, int depth);

Range joined(const Range &a, const Range &b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high), a.mayBeNan || b.mayBeNan};
}

/// Returns the range of a rounded product. Rounding is monotonic, so bounds stay bounds.
Range product(const Range &a, const Range &b) {
  const float corners[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  for (const float corner : corners)
    if (a.mayBeNan || b.mayBeNan || !std::isfinite(corner))
      return kUnknown;
  const auto [low, high] = std::minmax_element(std::begin(corners), std::end(corners));
  return {*low, *high, false};
}

Range sum(const Range &a, const Range &b) {
  const Range result = {a.low + b.low, a.high + b.high, false};
  const bool finite = std::isfinite(result.low) && std::isfinite(result.high);
  return a.mayBeNan || b.mayBeNan || !finite ? kUnknown : result;
}

Range negated(const Range &a) { return {-a.high, -a.low, a.mayBeNan}; }

/// Returns the range of the integer operand of a conversion to float.
Range integers(const Value *value) {
  const llvm::APInt *constant = nullptr;
  const auto upTo = [](std::uint64_t most) { return Range{0, float(most), false}; };
  if (match(value, m_And(m_Value(), m_APInt(constant))) && constant->isNonNegative())
    return upTo(constant->getZExtValue());
  if (match(value, m_LShr(m_Value(), m_APInt(constant))) && constant->ugt(0) && constant->ult(32))
    return upTo(0xFFFFFFFFu >> constant->getZExtValue());
  return {-0x1p31f, 0x1p31f, false};
}

/// Returns the range of a > b ? a : b, or with < of the minimum. The result is b if one is NaN.
Range extremum(const Range &a, const Range &b, bool larger) {
  if (!larger)
    return negated(extremum(negated(a), negated(b), true));
  return {a.mayBeNan ? b.low : std::max(a.low, b.low), std::max(a.high, b.high), b.mayBeNan};
}

Range selected(const llvm::SelectInst &select, int depth) {
  const Range yes = rangeAt(select.getTrueValue(), depth);
  const Range no = rangeAt(select.getFalseValue(), depth);
  if (const auto *const compare = llvm::dyn_cast<llvm::FCmpInst>(select.getCondition())) {
    const bool straight = compare->getOperand(0) == select.getTrueValue() &&
                          compare->getOperand(1) == select.getFalseValue();
    const bool crossed = compare->getOperand(1) == select.getTrueValue() &&
                         compare->getOperand(0) == select.getFalseValue();
    const auto predicate = compare->getPredicate();
    const bool greater =
        predicate == llvm::FCmpInst::FCMP_OGT || predicate == llvm::FCmpInst::FCMP_OGE;
    const bool less =
        predicate == llvm::FCmpInst::FCMP_OLT || predicate == llvm::FCmpInst::FCMP_OLE;
    if ((straight || crossed) && (greater || less))
      return extremum(yes, no, greater == straight);
  }
  return joined(yes, no);
}

Range called(const llvm::IntrinsicInst &call, int depth) {
  const auto operand = [&](unsigned i) { return rangeAt(call.getArgOperand(i), depth); };
  if (call.getIntrinsicID() == llvm::Intrinsic::fabs) {
    const Range a = operand(0);
    const float most = std::max(std::fabs(a.low), std::fabs(a.high));
    const bool crosses = a.low < 0 && a.high > 0;
    return {crosses ? 0 : std::min(std::fabs(a.low), std::fabs(a.high)), most, a.mayBeNan};
  }
  // This matches decode(): a number in the low bits of a mantissa, scaled.
  llvm::Value *bits = nullptr;
  const llvm::APInt *kept = nullptr, *exponent = nullptr;
  const llvm::APFloat *scale = nullptr, *sum = nullptr;
  if (call.getIntrinsicID() == llvm::Intrinsic::fma &&
      match(call.getArgOperand(0), m_BitCast(m_Value(bits))) &&
      match(bits, m_Or(m_And(m_Value(), m_APInt(kept)), m_APInt(exponent))) &&
      match(call.getArgOperand(1), m_APFloat(scale)) &&
      match(call.getArgOperand(2), m_APFloat(sum)) && kept->ule(0x7FFFFF) &&
      *exponent == 0x4B000000 && !scale->isNegative()) {
    const auto at = [&](double number) {
      return float(number * double(scale->convertToFloat()) + double(sum->convertToFloat()));
    };
    return {at(0x1p23), at(0x1p23 + double(kept->getZExtValue())), false};
  }
  // The result is the other operand if one is NaN. Bit 0 of the immediate selects maximum.
  if (call.getIntrinsicID() == llvm::Intrinsic::x86_avx512_mask_range_ps_512) {
    const Range a = operand(0), b = operand(1);
    const bool larger = llvm::cast<llvm::ConstantInt>(call.getArgOperand(2))->getZExtValue() & 1;
    Range result = a.mayBeNan && b.mayBeNan ? joined(a, b) : extremum(a, b, larger);
    if (b.mayBeNan && !a.mayBeNan)
      result = extremum(b, a, larger);
    result.mayBeNan = a.mayBeNan && b.mayBeNan;
    return result;
  }
  return kUnknown;
}

Range rangeAt(const Value *value, int depth) {
  const llvm::APFloat *constant = nullptr;
  if (match(value, m_APFloat(constant)) && !constant->isNaN()) {
    const float number = constant->convertToFloat();
    return {number, number, false};
  }
  const auto *const made = llvm::dyn_cast<llvm::Instruction>(value);
  if (!made || depth == 0 || !value->getType()->getScalarType()->isFloatTy())
    return kUnknown;
  const auto operand = [&](unsigned i) { return rangeAt(made->getOperand(i), depth - 1); };
  switch (made->getOpcode()) {
  case llvm::Instruction::SIToFP:
  case llvm::Instruction::UIToFP:
    return integers(made->getOperand(0));
  case llvm::Instruction::FMul:
    return product(operand(0), operand(1));
  case llvm::Instruction::FAdd:
    return sum(operand(0), operand(1));
  case llvm::Instruction::FSub:
    return sum(operand(0), negated(operand(1)));
  case llvm::Instruction::FNeg:
    return negated(operand(0));
  case llvm::Instruction::Select:
    return selected(llvm::cast<llvm::SelectInst>(*made), depth - 1);
  case llvm::Instruction::Call:
    if (const auto *const call = llvm::dyn_cast<llvm::IntrinsicInst>(made))
      return called(*call, depth - 1);
    return kUnknown;
  default:
    return kUnknown;
  }
}
} // namespace

Range rangeOf(const Value *value) { return rangeAt(value, kDepth); }

} // namespace arbiter::fp::llvm_back
