#include "fp_compiler/fixed_function.h"

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/opt/opt.h"

namespace arbiter::fp {

namespace {

/// Returns the parameter with an incomplete texture's value, and adds it if there is none.
std::uint16_t incompleteTexture(ir::Program &program) {
  constexpr ir::Vec4 kValue = {0, 0, 0, 1};
  for (std::size_t i = 0; i < program.parameters.size(); ++i)
    if (program.parameters[i].kind == ir::ParameterKind::Constant &&
        program.parameters[i].constant == kValue)
      return std::uint16_t(i);
  program.parameters.push_back({.kind = ir::ParameterKind::Constant, .constant = kValue});
  return std::uint16_t(program.parameters.size() - 1);
}

/// Replaces a sample by a copy of an incomplete texture's value.
void sampleNothing(ir::Program &program, ir::Instruction &sample) {
  sample.op = ir::Opcode::Mov;
  sample.src[0] = {};
  sample.src[0].file = ir::File::Parameter;
  sample.src[0].index = incompleteTexture(program);
  sample.src[0].span = sample.span;
}

} // namespace

ir::Program withFixedFunction(ir::Program program, const FixedFunction &state) {
  for (ir::Instruction &instruction : program.code) {
    if (!ir::info(instruction.op).has(ir::Texture) || instruction.unit >= state.targets.size())
      continue;
    if ((state.disabledUnits >> instruction.unit & 1u) != 0) {
      sampleNothing(program, instruction);
      continue;
    }
    instruction.target = state.targets[instruction.unit];
    program.options.shadow |= ir::isShadow(instruction.target);
  }
  program.options.fog = state.fog;
  program.options.colorSum = state.colorSum;
  return program;
}

ir::Program asArbFragment(ir::Program program) {
  program.language = ir::Language::ArbFragment;
  opt::lowerOptions(program, {.hasFog = true});
  return program;
}

} // namespace arbiter::fp
