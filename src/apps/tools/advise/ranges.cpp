#include "apps/tools/advise/ranges.h"

#include <algorithm>

#include "fp_compiler/analysis/range_analysis.h"

namespace arbiter::tools::advise {

namespace {

using fp::analysis::ValueRange;

/// Returns the range of a register's component before the instruction.
ValueRange ofComponent(const Subject &subject, const fp::analysis::RangeAnalysis &analysis,
                       const fp::ir::Operand &operand, std::size_t component) {
  const fp::ir::Program &program = subject.program();
  switch (operand.file) {
  case File::Temporary:
    return analysis.temporary(operand.index)[component];
  case File::Attribute:
    return fp::analysis::rangeOfAttribute(program.attributes[operand.index], program.language,
                                          int(component), fp::Numerics::Host);
  case File::Parameter: {
    if (operand.relative)
      return {};
    const fp::ir::Parameter &row = program.parameters[operand.index];
    return row.kind == fp::ir::ParameterKind::Constant
               ? fp::analysis::rangeOfNumber(row.constant[component])
               : ValueRange{};
  }
  case File::Output:
  case File::Address:
    break;
  }
  return {};
}

} // namespace

ValueRange rangeOf(const Subject &subject, std::uint32_t index, int operand, std::uint8_t mask) {
  fp::analysis::RangeAnalysis analysis(subject.program(), fp::Numerics::Host);
  for (std::uint32_t i = 0; i < index; ++i)
    analysis.step(subject.at(i));
  const fp::ir::Operand &source = subject.at(index).src[std::size_t(operand)];
  std::optional<ValueRange> all;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(mask >> i & 1))
      continue;
    const fp::ir::Select select = source.swizzle[i];
    ValueRange range = select == fp::ir::Select::Zero ? fp::analysis::rangeOfNumber(0.0f)
                       : select == fp::ir::Select::One
                           ? fp::analysis::rangeOfNumber(1.0f)
                           : ofComponent(subject, analysis, source, std::size_t(select));
    if (source.negate >> i & 1)
      range = fp::analysis::negated(range);
    all = all ? ValueRange{std::min(all->lo, range.lo), std::max(all->hi, range.hi),
                           all->number && range.number}
              : range;
  }
  return all.value_or(ValueRange{});
}

} // namespace arbiter::tools::advise
