#include "fp_compiler/front/nv/code.h"

namespace arbiter::fp::nv {

using ir::Operand;

Operand registerOf(ir::File file, std::uint16_t index) {
  Operand operand;
  operand.file = file;
  operand.index = index;
  return operand;
}

Operand temporary(std::uint16_t index) { return registerOf(ir::File::Temporary, index); }

Operand flagOf(std::uint16_t index) { return component(temporary(index), 0); }

ir::Destination writtenTo(std::uint16_t index, std::uint8_t mask) {
  ir::Destination dst;
  dst.index = index;
  dst.mask = mask;
  return dst;
}

Operand number(ir::Select select) {
  Operand operand;
  operand.swizzle.fill(select);
  return operand;
}

Operand swizzled(const Operand &operand, const ir::Swizzle &swizzle) {
  Operand result = operand;
  result.negate = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const ir::Select select = swizzle[i];
    if (select > ir::Select::W) {
      result.swizzle[i] = select;
      continue;
    }
    result.swizzle[i] = operand.swizzle[std::size_t(select)];
    result.negate |= std::uint8_t((operand.negate >> int(select) & 1) << i);
  }
  return result;
}

Operand component(const Operand &operand, int index) {
  const auto select = ir::Select(index);
  return swizzled(operand, {select, select, select, select});
}

Operand negated(Operand operand) {
  operand.negate ^= 0xF;
  return operand;
}

ir::Destination Code::scratch(std::uint8_t mask) {
  if (m_scratchUsed == m_scratch.size())
    m_scratch.push_back(m_binder.hiddenTemporary("", m_span));
  ir::Destination dst;
  dst.index = m_scratch[m_scratchUsed++];
  dst.mask = mask;
  return dst;
}

std::uint16_t Code::temporary(std::string_view name) {
  return m_binder.hiddenTemporary(name, m_span);
}

Operand Code::constant(float value) {
  return component(registerOf(ir::File::Parameter,
                              m_binder.hiddenConstant({value, value, value, value}, m_span)),
                   0);
}

void Code::append(ir::Instruction instruction) {
  instruction.span = instruction.dst.span = m_span;
  for (Operand &operand : instruction.src)
    if (operand.span.end == 0)
      operand.span = m_span;
  // number() names temporary 0, so it must exist.
  if (!m_binder.hasTemporaries())
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i)
      if (instruction.src[std::size_t(i)].file == ir::File::Temporary)
        (void)m_binder.hiddenTemporary("", m_span);
  m_binder.append(instruction, m_span);
}

void Code::write(ir::Opcode op, const ir::Destination &dst,
                 std::initializer_list<Operand> operands) {
  ir::Instruction instruction;
  instruction.op = op;
  instruction.dst = dst;
  std::size_t i = 0;
  for (const Operand &operand : operands)
    instruction.src[i++] = operand;
  append(instruction);
}

Operand Code::make(ir::Opcode op, std::initializer_list<Operand> operands, std::uint8_t mask) {
  const ir::Destination dst = scratch(mask);
  write(op, dst, operands);
  return registerOf(ir::File::Temporary, dst.index);
}

} // namespace arbiter::fp::nv
