#include "fp_compiler/ir/loop_counts.h"

#include <vector>

#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::ir {

std::uint64_t mostIterations(const Program &program, const Instruction &repeat) {
  const Operand &operand = repeat.src[0];
  const Select select = operand.swizzle[0];
  float count = select == Select::One ? 1.0f : 0.0f;
  if (select <= Select::W) {
    const bool known = operand.file == File::Parameter && !operand.relative &&
                       program.parameters[operand.index].kind == ParameterKind::Constant;
    if (!known)
      return kMaxIterations;
    count = program.parameters[operand.index].constant[std::size_t(select)];
  }
  return iterations((operand.negate & 1) != 0 ? -count : count);
}

bool endsByItself(const Program &program) {
  std::vector<std::uint64_t> times = {1}; // how often the code of each open loop runs
  std::uint64_t begun = 0;
  for (const Instruction &instruction : program.code) {
    if (instruction.op == Opcode::Rep) {
      times.push_back(times.back() * mostIterations(program, instruction));
      begun += times.back();
      if (begun >= kMaxIterations)
        return false;
    } else if (instruction.op == Opcode::Endrep) {
      times.pop_back();
    }
  }
  return true;
}

} // namespace arbiter::fp::ir
