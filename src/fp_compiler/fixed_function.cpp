#include "fp_compiler/fixed_function.h"

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp {

ir::Program withFixedFunction(ir::Program program, const FixedFunction &state) {
  for (ir::Instruction &instruction : program.code) {
    if (!ir::info(instruction.op).has(ir::Texture) || instruction.unit >= state.targets.size())
      continue;
    instruction.target = state.targets[instruction.unit];
    program.options.shadow |= ir::isShadow(instruction.target);
  }
  program.options.fog = state.fog;
  program.options.colorSum = state.colorSum;
  return program;
}

} // namespace arbiter::fp
