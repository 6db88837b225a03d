#include "fp_compiler/back/glsl/ranges.h"

#include <algorithm>

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/opt/values.h"

namespace arbiter::fp::glsl {

using ir::Instruction;
using ir::Opcode;
using ir::Operand;
using ir::Select;

namespace {
Range ofNumber(float value) {
  if (value >= 0.0f && value <= 1.0f)
    return Range::Unit;
  return value >= 0.0f ? Range::NotNegative : Range::Any;
}
} // namespace

Ranges::Ranges(const ir::Program &program)
    : m_program(program), m_temporaries(program.temporaries.size(),
                                        {Range::Unit, Range::Unit, Range::Unit, Range::Unit}) {}

Range Ranges::operand(const Operand &source, int position) const {
  const Select select = source.swizzle[std::size_t(position)];
  const bool negated = source.negate >> position & 1;
  if (select == Select::Zero)
    return Range::Unit;
  if (select == Select::One)
    return negated ? Range::Any : Range::Unit;
  if (source.relative)
    return Range::Any;
  if (source.file == ir::File::Parameter) {
    const ir::Parameter &parameter = m_program.parameters[source.index];
    if (parameter.kind != ir::ParameterKind::Constant)
      return Range::Any;
    const float value = parameter.constant[std::size_t(select)];
    return ofNumber(negated ? -value : value);
  }
  if (negated || source.file != ir::File::Temporary)
    return Range::Any;
  return m_temporaries[source.index][std::size_t(select)];
}

Proofs Ranges::proofs(const Operand &base, int basePosition, const Operand &exponent,
                      int exponentPosition) const {
  Proofs result;
  result.baseNotNegative = operand(base, basePosition) != Range::Any;
  if (const auto value = opt::constantAt(m_program, exponent, exponentPosition, Numerics::Host)) {
    result.exponentNotZero = *value != 0.0f;
    result.exponentPositive = *value > 0.0f;
  }
  return result;
}

Proofs Ranges::proofs(const Instruction &instruction) const {
  const auto &src = instruction.src;
  if (instruction.op == Opcode::Pow)
    return proofs(src[0], 0, src[1], 0);
  if (instruction.op == Opcode::Lit)
    return proofs(src[0], 1, src[0], 3);
  return {};
}

Range Ranges::result(const Instruction &instruction, int position) const {
  const auto range = [&](int source) {
    return operand(instruction.src[std::size_t(source)], position);
  };
  switch (instruction.op) {
  case Opcode::Mov:
  case Opcode::Swz:
  case Opcode::Abs:
    return range(0);
  case Opcode::Sge:
  case Opcode::Slt:
    return Range::Unit;
  case Opcode::Max: // gives the number if one operand is NaN
    return std::max(range(0), range(1)) == Range::Unit && range(0) == range(1)
               ? Range::Unit
               : std::min(std::max(range(0), range(1)), Range::NotNegative);
  case Opcode::Min:
  case Opcode::Cmp: {
    const int first = instruction.op == Opcode::Cmp ? 1 : 0;
    return std::min(range(first), range(first + 1));
  }
  case Opcode::Mul: // infinity times zero is NaN, so only finite operands tell
    return std::min(range(0), range(1)) == Range::Unit ? Range::Unit : Range::Any;
  case Opcode::Add:
    return std::min(range(0), range(1)) == Range::Any ? Range::Any : Range::NotNegative;
  case Opcode::Mad:
    return std::min(range(0), range(1)) == Range::Unit && range(2) != Range::Any
               ? Range::NotNegative
               : Range::Any;
  default:
    return Range::Any;
  }
}

void Ranges::step(const Instruction &instruction) {
  const std::uint8_t mask = ir::writeMask(instruction);
  if (mask == 0 || instruction.dst.file != ir::File::Temporary)
    return;
  // Operands are read before any component is written.
  std::array<Range, 4> after = m_temporaries[instruction.dst.index];
  for (int i = 0; i < 4; ++i)
    if (mask >> i & 1)
      after[std::size_t(i)] = instruction.dst.saturate ? Range::Unit : result(instruction, i);
  m_temporaries[instruction.dst.index] = after;
}

} // namespace arbiter::fp::glsl
