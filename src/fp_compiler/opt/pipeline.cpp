#include <cassert>

#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/opt/opt.h"

namespace arbiter::fp {

namespace opt {

namespace {
/// Copies first, so that folding sees through them; sharing before dead code, which sweeps up what
/// all of them leave.
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

/// A chain of constants folds by one link a round. Programs within a card's limits are at rest
/// long before; without a bound one of 10,000 additions takes 10,000 rounds over all of it.
constexpr int kMaxRounds = 64;
} // namespace

void run(ir::Program &program, Numerics numerics) {
  // The others go through straight-line code. A host's compiler has its own for loops.
  (void)unrollLoops(program);
  // Most of what it leaves is dead: the others need not look at it.
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
