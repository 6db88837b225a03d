#include "fp_compiler/ir/loop_counts.h"
#include "fp_compiler/opt/opt.h"

namespace arbiter::fp::opt {

namespace {
/// A loop whose end has not come yet.
struct Open {
  std::size_t begin = 0; ///< of its REP in the code that is made
  bool breaks = false;
};

/// What a loop, and all of them together, may become: beyond it more code costs more than its
/// loops.
constexpr std::uint64_t kMostInstructions = 1024;
} // namespace

bool unrollLoops(ir::Program &program) {
  // A run that comes to the cap on iterations ends in the middle of them.
  if (!ir::hasLoops(program) || !ir::endsByItself(program))
    return false;
  // All that may be, or none: what a run leaves, another one would leave too.
  std::vector<ir::Instruction> made;
  std::vector<Open> open;
  bool changed = false;
  std::uint64_t written = 0; // instructions that stood in loops
  for (const ir::Instruction &instruction : program.code) {
    if (instruction.op == ir::Opcode::Rep)
      open.push_back({made.size()});
    else if (instruction.op == ir::Opcode::Brk)
      open.back().breaks = true;
    if (instruction.op != ir::Opcode::Endrep) {
      made.push_back(instruction);
      continue;
    }
    const Open loop = open.back();
    open.pop_back();
    const std::uint64_t count = ir::mostIterations(program, made[loop.begin]);
    const std::size_t size = made.size() - loop.begin - 1;
    if (loop.breaks || count * size > kMostInstructions) {
      made.push_back(instruction);
      continue;
    }
    written += count * size;
    if (written > kMostInstructions)
      return false;
    changed = true;
    made.erase(made.begin() + std::ptrdiff_t(loop.begin));
    if (count == 0)
      made.resize(loop.begin);
    made.reserve(made.size() + std::size_t(count) * size);
    for (std::uint64_t i = 1; i < count; ++i)
      for (std::size_t at = 0; at < size; ++at)
        made.push_back(made[loop.begin + at]);
  }
  program.code = std::move(made);
  return changed;
}

} // namespace arbiter::fp::opt
