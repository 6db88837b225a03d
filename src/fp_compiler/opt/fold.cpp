#include <cassert>
#include <cmath>

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/values.h"

namespace arbiter::fp::opt {

namespace {
/// True if the instruction is a MOV of a constant already, which is what folding produces.
bool isFolded(const Instruction &instruction) {
  if (instruction.op != Opcode::Mov || instruction.dst.saturate)
    return false;
  for (int i = 0; i < 4; ++i)
    if ((instruction.dst.mask >> i & 1) &&
        instruction.src[0].swizzle[std::size_t(i)] > ir::Select::W)
      return false;
  return true;
}

/// True for PK* and UP*. A constant row, read as numbers, may lose the bits they produce.
bool packs(Opcode op) { return int(op) >= ir::kOpcodeCount && ir::carriesBits(op); }

/// Returns the values of the operands in the components that are read, or nothing if one is not
/// constant.
std::optional<ir::Operands> constantOperands(const ir::Program &program,
                                             const Instruction &instruction, Numerics numerics) {
  ir::Operands operands = {};
  for (int s = 0; s < ir::info(instruction.op).operandCount(); ++s) {
    const std::uint8_t reads = ir::operandMask(instruction, s);
    for (int i = 0; i < 4; ++i) {
      if (!(reads >> i & 1))
        continue;
      const auto value = constantAt(program, instruction.src[std::size_t(s)], i, numerics);
      if (!value)
        return {};
      operands[std::size_t(s)][std::size_t(i)] = *value;
    }
  }
  return operands;
}

/// Returns the constant result, or nothing if it is infinite or NaN. Components outside the mask
/// repeat one inside, so that rows can be shared. The value is a number of the mode, so loading it
/// as a constant does not change it.
std::optional<ir::Vec4> result(const Instruction &instruction, const ir::Operands &operands,
                               Numerics numerics, ir::Language language) {
  ir::Vec4 value = ir::apply(instruction.op, operands, numerics, language);
  float filler = 0.0f;
  for (std::size_t i = 4; i-- > 0;) {
    if (!(instruction.dst.mask >> i & 1))
      continue;
    if (instruction.dst.saturate)
      value[i] = ir::saturated(value[i]);
    if (!std::isfinite(value[i]))
      return {};
    assert(ir::loaded(value[i], numerics) == value[i]);
    filler = value[i];
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (!(instruction.dst.mask >> i & 1))
      value[i] = filler;
  return value;
}
} // namespace

bool foldConstants(ir::Program &program, Numerics asked) {
  const Numerics numerics = ir::numericsOf(program.language, asked);
  ConstantRows rows(program);
  bool changed = false;
  for (Instruction &instruction : program.code) {
    const ir::OpInfo &row = ir::info(instruction.op);
    if (row.has(ir::Texture) || row.has(ir::Kills) || isFolded(instruction) ||
        instruction.dst.file == ir::File::Address || !rows.hasRoom() || packs(instruction.op))
      continue;
    const auto operands = constantOperands(program, instruction, numerics);
    if (!operands)
      continue;
    const auto value = result(instruction, *operands, numerics, program.language);
    if (!value)
      continue;
    instruction.src = {rows.operand(*value, instruction.src[0].span), {}, {}};
    instruction.op = Opcode::Mov;
    instruction.dst.saturate = false;
    changed = true;
  }
  return changed;
}

} // namespace arbiter::fp::opt
