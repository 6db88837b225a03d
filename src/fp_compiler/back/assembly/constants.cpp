#include "fp_compiler/back/assembly/constants.h"

#include <algorithm>
#include <cstring>

namespace arbiter::fp::assembly {

using ir::Opcode;
using ir::Operand;
using ir::Parameter;
using ir::ParameterKind;
using ir::Select;

namespace {

/// Returns what the operand reads of a constant.
ir::Vec4 valueOf(const ir::Vec4 &constant, const Operand &operand) {
  ir::Vec4 value = {};
  for (std::size_t i = 0; i < 4; ++i) {
    const Select select = operand.swizzle[i];
    const float read =
        select <= Select::W ? constant[std::size_t(select)] : (select == Select::One ? 1.0f : 0.0f);
    value[i] = (operand.negate >> i & 1) != 0 ? -read : read;
  }
  return value;
}

/// Returns the row that has this constant, to the bit. Adds it if there is none.
std::uint16_t rowOf(ir::Program &program, const ir::Vec4 &value) {
  std::size_t row = 0;
  for (; row < program.parameters.size(); ++row) {
    const Parameter &parameter = program.parameters[row];
    if (parameter.kind == ParameterKind::Constant &&
        std::memcmp(parameter.constant.data(), value.data(), sizeof value) == 0)
      return std::uint16_t(row);
  }
  program.parameters.push_back({ParameterKind::Constant, value, 0, {}});
  return std::uint16_t(row);
}

bool isConstant(const ir::Program &program, const Operand &operand) {
  return operand.file == ir::File::Parameter && !operand.relative &&
         program.parameters[operand.index].kind == ParameterKind::Constant;
}

} // namespace

bool isExtended(const Operand &operand) {
  return (operand.negate != 0 && operand.negate != 0xF) ||
         std::any_of(operand.swizzle.begin(), operand.swizzle.end(),
                     [](Select select) { return select > Select::W; });
}

ir::Program withPlainConstants(ir::Program program) {
  for (ir::Instruction &instruction : program.code)
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i) {
      Operand &operand = instruction.src[std::size_t(i)];
      const bool swizzles = instruction.op == Opcode::Swz;
      if ((!swizzles && !isExtended(operand)) || !isConstant(program, operand))
        continue;
      operand.index = rowOf(program, valueOf(program.parameters[operand.index].constant, operand));
      operand.swizzle = ir::kIdentity;
      operand.negate = 0;
      if (swizzles)
        instruction.op = Opcode::Mov;
    }
  return program;
}

} // namespace arbiter::fp::assembly
