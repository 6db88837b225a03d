#include "fp_compiler/ir/loop_counts.h"
#include "fp_compiler/opt/opt.h"

namespace arbiter::fp::opt {

namespace {
/// A loop whose ENDREP has not been reached yet.
struct Open {
  std::size_t begin = 0; ///< index of its REP in the new code
  bool breaks = false;
};

/// Maximum size of one unrolled loop, and of all together. Longer code costs more than the loop
/// saves.
constexpr std::uint64_t kMaxInstructions = 1024;
} // namespace

bool unrollLoops(ir::Program &program) {
  // An invocation that reaches the cap on iterations may stop in the middle of a loop.
  if (!ir::hasLoops(program) || !ir::endsByItself(program))
    return false;
  // Either all loops that qualify are unrolled or none. A partial result would differ when the pass
  // runs again.
  std::vector<ir::Instruction> made;
  std::vector<Open> open;
  bool changed = false;
  std::uint64_t written = 0; // number of instructions from loops
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
    if (loop.breaks || count * size > kMaxInstructions) {
      made.push_back(instruction);
      continue;
    }
    written += count * size;
    if (written > kMaxInstructions)
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
