#include "fp_compiler/opt/known.h"

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/opt/values.h"

namespace arbiter::fp::opt {

KnownValues::KnownValues(const ir::Program &program, Numerics numerics)
    : m_program(program), m_numerics(numerics), m_components(program.temporaries.size()) {
  for (Components &components : m_components)
    components.fill(0.0f);
}

std::optional<float> KnownValues::at(const Operand &operand, int position) const {
  const Select select = operand.swizzle[std::size_t(position)];
  if (operand.file != File::Temporary || select > Select::W)
    return constantAt(m_program, operand, position, m_numerics);
  const std::optional<float> value = m_components[operand.index][std::size_t(select)];
  return value && (operand.negate >> position & 1) ? -*value : value;
}

KnownValues::Components KnownValues::results(const Instruction &instruction) const {
  Components values = {};
  for (int i = 0; i < 4; ++i)
    if (instruction.dst.mask >> i & 1)
      values[std::size_t(i)] = resultAt(instruction, i);
  return values;
}

void KnownValues::set(const ir::Destination &dst, const Components &values) {
  for (std::size_t i = 0; i < 4; ++i)
    if (dst.mask >> i & 1)
      m_components[dst.index][i] = values[i];
}

std::optional<float> KnownValues::resultAt(Instruction instruction, int component) const {
  const ir::OpInfo &row = ir::info(instruction.op);
  const bool packs = int(instruction.op) >= ir::kOpcodeCount && ir::carriesBits(instruction.op);
  if (row.has(ir::Texture) || packs || instruction.op == Opcode::Ddx ||
      instruction.op == Opcode::Ddy)
    return {};
  if (instruction.op == Opcode::Cmp && !instruction.dst.saturate) {
    const std::optional<float> chooses = at(instruction.src[0], component);
    if (!chooses)
      return {};
    return at(instruction.src[*chooses < 0.0f ? 1 : 2], component);
  }
  instruction.dst.mask = std::uint8_t(1 << component);
  ir::Operands operands = {};
  for (int s = 0; s < row.operandCount(); ++s) {
    const std::uint8_t reads = ir::operandMask(instruction, s);
    for (int i = 0; i < 4; ++i) {
      if (!(reads >> i & 1))
        continue;
      const std::optional<float> value = at(instruction.src[std::size_t(s)], i);
      if (!value)
        return {};
      operands[std::size_t(s)][std::size_t(i)] = *value;
    }
  }
  const float value =
      ir::apply(instruction.op, operands, m_numerics, m_program.language)[std::size_t(component)];
  return instruction.dst.saturate ? ir::saturated(value) : value;
}

} // namespace arbiter::fp::opt
