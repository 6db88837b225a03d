#include <cassert>

#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/opt/opt.h"

namespace arbiter::fp {

namespace opt {

namespace {
/// Runs one round of passes. Copy propagation comes first, so that folding sees through copies.
/// Dead code removal comes last and cleans up after the others.
bool round(ir::Program &program, Numerics numerics) {
  bool progress = false;
  const auto count = [&](bool changed) {
    progress |= changed;
    assert(ir::validate(program).empty());
  };
  count(propagateCopies(program));
  count(foldConstants(program, numerics));
  count(simplify(program, numerics));
  count(resolveAddresses(program, numerics));
  count(shareExpressions(program));
  count(removeDeadCode(program));
  return progress;
}

/// Maximum number of rounds. A chain of constants folds by one link a round. Programs within a
/// card's limits need far fewer rounds. Without a bound, 10,000 additions would take 10,000 rounds.
constexpr int kMaxRounds = 64;
} // namespace

void run(ir::Program &program, Numerics numerics) {
  // The other passes handle straight-line code only. The host's compiler optimises loops itself.
  (void)unrollLoops(program);
  // Most of the resulting code is dead. Removing it first saves work in the other passes.
  if (followLoops(program, numerics) && propagateCopies(program))
    (void)removeDeadCode(program);
  if (ir::hasLoops(program))
    return;
  for (int rounds = 0; rounds < kMaxRounds; ++rounds)
    if (!round(program, numerics))
      return;
}

} // namespace opt

void optimise(ir::Program &program, Numerics numerics) { opt::run(program, numerics); }

} // namespace arbiter::fp
