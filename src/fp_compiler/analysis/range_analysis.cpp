#include "fp_compiler/analysis/range_analysis.h"

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::analysis {

using ir::Instruction;
using ir::Opcode;
using ir::Operand;
using ir::Select;

namespace {
/// Returns the factors to compare with zero. A zero matters only if the other factor may be
/// infinite or NaN.
Guard guardOf(const ValueRange &a, const ValueRange &b) {
  const bool left = a.mayBeZero() && !b.finite();
  const bool right = b.mayBeZero() && !a.finite();
  return Guard((left ? int(Guard::Left) : 0) | (right ? int(Guard::Right) : 0));
}

void widen(Guard &guard, Guard other) { guard = Guard(int(guard) | int(other)); }
} // namespace

RangeAnalysis::RangeAnalysis(const ir::Program &program, Numerics numerics)
    : m_program(program), m_numerics(numerics),
      m_temporaries(program.temporaries.size(), ValueRange4{rangeOfNumber(0), rangeOfNumber(0),
                                                            rangeOfNumber(0), rangeOfNumber(0)}) {}

ValueRange RangeAnalysis::read(const Operand &source, std::size_t component) const {
  if (source.relative)
    return {};
  switch (source.file) {
  case ir::File::Temporary:
    return m_temporaries[source.index][component];
  case ir::File::Attribute:
    return rangeOfAttribute(m_program.attributes[source.index], m_program.language, int(component),
                            m_numerics);
  case ir::File::Parameter: {
    const ir::Parameter &parameter = m_program.parameters[source.index];
    if (parameter.kind != ir::ParameterKind::Constant)
      return {};
    return rangeOfNumber(ir::loaded(parameter.constant[component], m_numerics));
  }
  case ir::File::Output:
  case ir::File::Address:
    break;
  }
  return {};
}

ValueRange RangeAnalysis::operand(const Operand &source, int position) const {
  const Select select = source.swizzle[std::size_t(position)];
  const ValueRange value = select == Select::Zero  ? rangeOfNumber(0.0f)
                           : select == Select::One ? rangeOfNumber(1.0f)
                                                   : read(source, std::size_t(select));
  return source.negate >> position & 1 ? negated(value) : value;
}

ValueRange4 RangeAnalysis::operand(const Operand &source) const {
  return {operand(source, 0), operand(source, 1), operand(source, 2), operand(source, 3)};
}

std::array<ValueRange4, 3> RangeAnalysis::operands(const Instruction &instruction) const {
  std::array<ValueRange4, 3> result;
  for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i)
    result[std::size_t(i)] = operand(instruction.src[std::size_t(i)]);
  return result;
}

void RangeAnalysis::findBaseFacts(OperandFacts &facts, const Operand &base, int basePosition,
                                  const Operand &exponent, int exponentPosition) const {
  facts.baseNotNegative = operand(base, basePosition).notNegative();
  const ValueRange power = operand(exponent, exponentPosition);
  facts.exponentFinite = power.finite();
  facts.exponentNotZero = power.number && !power.mayBeZero();
  facts.exponentPositive = power.finite() && power.lo > 0.0f;
}

void RangeAnalysis::findProductFacts(OperandFacts &facts, const Instruction &instruction) const {
  const std::array<ValueRange4, 3> values = operands(instruction);
  const ValueRange4 &a = values[0], &b = values[1], &c = values[2];
  const auto product = [&](std::size_t i) { widen(facts.first, guardOf(a[i], b[i])); };
  switch (instruction.op) {
  case Opcode::Mul:
  case Opcode::Mad:
    for (std::size_t i = 0; i < 4; ++i)
      if (instruction.dst.mask >> i & 1)
        product(i);
    break;
  case Opcode::Dp3:
  case Opcode::Dph:
  case Opcode::Dp4:
    for (std::size_t i = 0; i < (instruction.op == Opcode::Dp4 ? 4u : 3u); ++i)
      product(i);
    break;
  case Opcode::Dst:
    product(1);
    break;
  case Opcode::Lrp:
    for (std::size_t i = 0; i < 4; ++i) {
      if (!(instruction.dst.mask >> i & 1))
        continue;
      product(i);
      Instruction rest;
      rest.op = Opcode::Sub;
      const ValueRange4 one = {rangeOfNumber(1), rangeOfNumber(1), rangeOfNumber(1),
                               rangeOfNumber(1)};
      widen(facts.second, guardOf(rangeOfResult(rest, {one, a, {}}, m_numerics)[i], c[i]));
    }
    break;
  case Opcode::Xpd:
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      widen(facts.first, guardOf(a[j], b[k]));
      widen(facts.second, guardOf(a[k], b[j]));
    }
    break;
  default:
    break;
  }
}

OperandFacts RangeAnalysis::facts(const Instruction &instruction) const {
  OperandFacts facts;
  const auto &src = instruction.src;
  if (instruction.op == Opcode::Pow)
    findBaseFacts(facts, src[0], 0, src[1], 0);
  if (instruction.op == Opcode::Lit)
    findBaseFacts(facts, src[0], 1, src[0], 3);
  if (m_numerics != Numerics::Host)
    findProductFacts(facts, instruction);
  return facts;
}

void RangeAnalysis::forget() { m_temporaries.assign(m_temporaries.size(), ValueRange4{}); }

void RangeAnalysis::step(const Instruction &instruction) {
  const std::uint8_t mask = ir::writeMask(instruction);
  if (mask == 0 || instruction.dst.file != ir::File::Temporary)
    return;
  const ValueRange4 result = rangeOfResult(instruction, operands(instruction), m_numerics);
  for (std::size_t i = 0; i < 4; ++i)
    if (mask >> i & 1)
      m_temporaries[instruction.dst.index][i] =
          instruction.dst.saturate ? saturated(result[i]) : result[i];
}

} // namespace arbiter::fp::analysis
