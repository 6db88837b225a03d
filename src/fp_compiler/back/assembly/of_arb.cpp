#include <algorithm>
#include <cmath>

#include "fp_compiler/back/assembly/assembly.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp {

using ir::AttributeKind;
using ir::Instruction;
using ir::Operand;

namespace {
bool isFinite(const ir::Vec4 &value) {
  return std::all_of(value.begin(), value.end(), [](float each) { return std::isfinite(each); });
}

/// True if the instruction writes components that the ARB leaves undefined and this project
/// defines.
bool writesUndefined(const Instruction &instruction) {
  if (!ir::info(instruction.op).has(ir::FixedMask))
    return false;
  return (instruction.dst.mask & (instruction.op == ir::Opcode::Scs ? 0xC : 0x8)) != 0;
}

bool isOfArb(const ir::Program &program, const Operand &operand, bool addresses) {
  if (operand.file == ir::File::Attribute)
    return program.attributes[operand.index].kind != AttributeKind::Facing;
  if (operand.file != ir::File::Parameter)
    return true;
  if (!operand.relative)
    return isFinite(program.parameters[operand.index].constant);
  const auto &rows = program.arrays[operand.index].rows;
  return addresses && std::all_of(rows.begin(), rows.end(), [&](std::uint16_t row) {
           return isFinite(program.parameters[row].constant);
         });
}

bool isOfArb(const ir::Program &program, const Instruction &instruction, bool addresses) {
  const ir::OpInfo &row = ir::info(instruction.op);
  const bool vertex = program.language == ir::Language::ArbVertex;
  if (int(instruction.op) >= ir::kOpcodeCount ||
      row.has(vertex ? ir::FragmentOnly : ir::VertexOnly) || (vertex && instruction.dst.saturate) ||
      writesUndefined(instruction))
    return false;
  if (ir::writeMask(instruction) != 0 && instruction.dst.file == ir::File::Output) {
    const ir::OutputKind kind = program.outputs[instruction.dst.index].kind;
    if (kind == ir::OutputKind::ClipDistance || kind == ir::OutputKind::EnvParameter)
      return false;
  }
  for (int i = 0; i < row.operandCount(); ++i)
    if (!isOfArb(program, instruction.src[std::size_t(i)], addresses))
      return false;
  return true;
}
} // namespace

bool bindsOneTwice(const ir::Program &program) {
  for (const ir::Attribute &generic : program.attributes)
    for (const ir::Attribute &other : program.attributes)
      if (generic.kind == AttributeKind::Generic && other.kind != AttributeKind::Generic &&
          generic.index == ir::genericNumberOf(other))
        return true;
  return false;
}

bool isOfArb(const ir::Program &program, bool addresses) {
  if (program.language == ir::Language::AtiFragment || program.options.colorSum ||
      (program.language == ir::Language::ArbVertex && bindsOneTwice(program)))
    return false;
  return std::all_of(program.code.begin(), program.code.end(), [&](const Instruction &instruction) {
    return isOfArb(program, instruction, addresses);
  });
}

} // namespace arbiter::fp
