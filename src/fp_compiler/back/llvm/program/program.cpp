#include "fp_compiler/back/llvm/program/program.h"

#include <limits>

#include "fp_compiler/analysis/live_values.h"
#include "fp_compiler/analysis/range_analysis.h"
#include "fp_compiler/back/llvm/math/math.h"
#include "fp_compiler/back/llvm/program/arithmetic.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::llvm_back {

using ir::File;
using ir::Instruction;
using ir::Operand;
using ir::Select;

namespace {
class Walk {
public:
  Walk(Code &code, const ir::Program &program, Numerics numerics, ProgramHooks &hooks)
      : m_code(code), m_program(program), m_numerics(ir::numericsOf(program.language, numerics)),
        m_hooks(hooks), m_live(analysis::liveOf(program)), m_ranges(program, m_numerics),
        m_temporaries(program.temporaries.size()), m_attributes(program.attributes.size()),
        m_parameters(program.parameters.size()), m_addresses(program.addresses.size()) {
    m_results.outputs.resize(program.outputs.size());
  }

  ProgramResults run() {
    for (std::size_t i = 0; i < m_program.code.size(); ++i) {
      if (m_live.written[i] != 0)
        step(analysis::narrowed(m_program.code[i], m_live.written[i]));
      if (m_numerics == Numerics::Legacy)
        m_ranges.step(m_program.code[i]);
    }
    return std::move(m_results);
  }

private:
  void step(const Instruction &instruction);
  void write(const ir::Destination &dst, const Vec &value);
  /// The operand's components at the positions of \p mask, swizzled and negated.
  Vec fetch(const Operand &operand, unsigned mask, unsigned registerMask);
  Vec source(const Operand &operand, unsigned registerMask);
  Vec row(std::uint16_t index);
  Value *address(const Operand &operand);
  Value *addressOf(Value *value);
  analysis::OperandFacts facts(const Instruction &instruction) const {
    return m_numerics == Numerics::Legacy ? m_ranges.facts(instruction) : analysis::OperandFacts{};
  }

  Code &m_code;
  const ir::Program &m_program;
  Numerics m_numerics;
  ProgramHooks &m_hooks;
  analysis::LiveValues m_live;
  analysis::RangeAnalysis m_ranges;
  /// Null components have not been written, or not been asked for yet.
  std::vector<Vec> m_temporaries, m_attributes, m_parameters;
  std::vector<Value *> m_addresses;
  ProgramResults m_results;
};

bool isEmpty(const Vec &value) { return !value[0] && !value[1] && !value[2] && !value[3]; }

Vec Walk::row(std::uint16_t index) {
  const ir::Parameter &parameter = m_program.parameters[index];
  Vec &value = m_parameters[index];
  if (!isEmpty(value))
    return value;
  if (parameter.kind == ir::ParameterKind::Constant)
    for (std::size_t i = 0; i < 4; ++i)
      value[i] = m_code.splat(ir::loaded(parameter.constant[i], m_numerics));
  else
    value = m_hooks.parameter(index, m_live.parameters[index]);
  return value;
}

/// Where there is no such row is for the hook to know: only sums that wrap are kept away.
Value *Walk::address(const Operand &operand) {
  Value *const base = m_addresses[operand.address];
  Value *const offset = m_code.splat(int(operand.offset));
  return base ? m_code.ir.CreateAdd(base, offset) : offset;
}

Value *Walk::addressOf(Value *value) {
  Value *const floor = m_code.floor(value);
  Value *const fits = m_code.ir.CreateFCmpOLT(absolute(m_code, floor), m_code.splat(0x1p30f));
  return m_code.select(fits, m_code.toInt(floor),
                       m_code.splat(std::numeric_limits<int>::min() / 2));
}

Vec Walk::source(const Operand &operand, unsigned registerMask) {
  switch (operand.file) {
  case File::Temporary:
    return m_temporaries[operand.index];
  case File::Attribute: {
    Vec &value = m_attributes[operand.index];
    if (isEmpty(value))
      value = m_hooks.attribute(operand.index, m_live.attributes[operand.index]);
    return value;
  }
  case File::Parameter:
    return operand.relative ? m_hooks.relative(operand.index, address(operand), registerMask)
                            : row(operand.index);
  case File::Output:
  case File::Address:
    break; // write only
  }
  return {};
}

Vec Walk::fetch(const Operand &operand, unsigned mask, unsigned registerMask) {
  const Vec from = registerMask != 0 ? source(operand, registerMask) : Vec{};
  Vec value = {};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(mask >> i & 1))
      continue;
    const Select select = operand.swizzle[i];
    value[i] = select == Select::Zero  ? nullptr
               : select == Select::One ? m_code.splat(1.0f)
                                       : from[std::size_t(select)];
    if (!value[i])
      value[i] = m_code.splat(0.0f);
    if (operand.negate >> i & 1)
      value[i] = m_code.ir.CreateFNeg(value[i]);
  }
  return value;
}

void Walk::step(const Instruction &instruction) {
  const ir::OpInfo &row = ir::info(instruction.op);
  OperandValues operands = {};
  for (int i = 0; i < row.operandCount(); ++i)
    operands[std::size_t(i)] =
        fetch(instruction.src[std::size_t(i)], ir::operandMask(instruction, i),
              ir::registerMask(instruction, i));
  if (row.has(ir::Kills)) {
    m_hooks.kill(kills(m_code, operands[0]));
    return;
  }
  if (instruction.op == ir::Opcode::Arl) {
    m_addresses[instruction.dst.index] = addressOf(operands[0][0]);
    return;
  }
  const unsigned needed = instruction.dst.mask;
  write(instruction.dst, row.has(ir::Texture)
                             ? m_hooks.texture(instruction, operands[0], needed)
                             : apply(m_code, instruction.op, operands, needed, facts(instruction),
                                     m_numerics, m_program.language));
}

void Walk::write(const ir::Destination &dst, const Vec &value) {
  Vec &target = dst.file == File::Output ? m_results.outputs[dst.index] : m_temporaries[dst.index];
  for (std::size_t i = 0; i < 4; ++i)
    if (dst.mask >> i & 1)
      target[i] = dst.saturate ? m_code.saturate(value[i]) : value[i];
}
} // namespace

ProgramResults writeProgram(Code &code, const ir::Program &program, Numerics numerics,
                            ProgramHooks &hooks) {
  return Walk(code, program, numerics, hooks).run();
}

} // namespace arbiter::fp::llvm_back
