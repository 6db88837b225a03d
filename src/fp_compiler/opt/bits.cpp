#include "fp_compiler/opt/bits.h"

#include <algorithm>

#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::opt {

namespace {
bool hasDenormals(const ir::Vec4 &constant) {
  return std::any_of(constant.begin(), constant.end(),
                     [](float value) { return ir::flushed(value) != value; });
}
} // namespace

HeldBits::HeldBits(const ir::Program &program, Numerics numerics)
    : m_program(program), m_inParameters(numerics != Numerics::Fp24) {
  if (program.options.nv == ir::NvOption::None)
    return;
  m_temporaries.resize(program.temporaries.size(), false);
  for (bool changed = true; changed;) { // values may flow from the end of a loop to its start
    changed = false;
    for (const Instruction &instruction : program.code) {
      if (!ir::carriesBits(instruction.op) || instruction.dst.file != File::Temporary ||
          m_temporaries[instruction.dst.index])
        continue;
      const int operands = ir::info(instruction.op).operandCount();
      const auto &sources = instruction.src;
      changed |= m_temporaries[instruction.dst.index] =
          int(instruction.op) >= ir::kOpcodeCount ||
          std::any_of(sources.begin(), sources.begin() + operands,
                      [this](const Operand &source) { return mayBeIn(source); });
    }
  }
}

bool HeldBits::mayBeIn(const Operand &operand) const {
  if (m_temporaries.empty())
    return false;
  switch (operand.file) {
  case File::Temporary:
    return m_temporaries[operand.index];
  case File::Parameter: {
    if (!m_inParameters)
      return false;
    const bool isConstant = !operand.relative &&
                            m_program.parameters[operand.index].kind == ir::ParameterKind::Constant;
    return !isConstant || hasDenormals(m_program.parameters[operand.index].constant);
  }
  case File::Attribute:
  case File::Output:
  case File::Address:
    break;
  }
  return false;
}

} // namespace arbiter::fp::opt
