#include <algorithm>

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/opt/opt.h"

namespace arbiter::fp::opt {

bool removeDeadCode(ir::Program &program) {
  std::vector<std::uint8_t> temporaries(program.temporaries.size(), 0);
  std::vector<std::uint8_t> outputs(program.outputs.size(), 0xF);
  for (std::size_t i = 0; i < outputs.size(); ++i)
    outputs[i] = ir::resultMask(program.outputs[i].kind);
  std::vector<std::uint8_t> addresses(program.addresses.size(), 0);
  bool changed = false;
  std::vector<bool> dead(program.code.size(), false);
  for (std::size_t at = program.code.size(); at-- > 0;) {
    Instruction &instruction = program.code[at];
    if (!ir::info(instruction.op).has(ir::Kills)) {
      auto &file = instruction.dst.file == File::Output    ? outputs
                   : instruction.dst.file == File::Address ? addresses
                                                           : temporaries;
      std::uint8_t &live = file[instruction.dst.index];
      const auto needed = std::uint8_t(instruction.dst.mask & live);
      changed |= needed != instruction.dst.mask;
      if (needed == 0) {
        dead[at] = true;
        continue;
      }
      instruction.dst.mask = needed;
      live &= std::uint8_t(~needed);
    }
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i) {
      const ir::Operand &operand = instruction.src[std::size_t(i)];
      const std::uint8_t reads = ir::registerMask(instruction, i);
      if (operand.file == File::Temporary)
        temporaries[operand.index] |= reads;
      else if (operand.relative && reads != 0)
        addresses[operand.address] = 1;
    }
  }
  std::size_t kept = 0;
  for (std::size_t at = 0; at < program.code.size(); ++at)
    if (!dead[at]) {
      if (kept != at)
        program.code[kept] = program.code[at];
      ++kept;
    }
  program.code.resize(kept);
  return changed;
}

} // namespace arbiter::fp::opt
