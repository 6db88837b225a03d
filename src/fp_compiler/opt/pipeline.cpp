#include <cassert>

#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/opt/opt.h"

namespace arbiter::fp {

namespace opt {

namespace {
using Pass = bool (*)(ir::Program &);

/// Copies first, so that folding sees through them; sharing before dead code, which sweeps up what
/// all of them leave.
constexpr Pass kPasses[] = {propagateCopies, foldConstants, simplify, shareExpressions,
                            removeDeadCode};

/// A chain of constants folds by one link a round. Programs within a card's limits are at rest
/// long before; without a bound one of 10,000 additions takes 10,000 rounds over all of it.
constexpr int kMaxRounds = 64;
} // namespace

void run(ir::Program &program) {
  bool progress = true;
  for (int round = 0; progress && round < kMaxRounds; ++round) {
    progress = false;
    for (const Pass pass : kPasses) {
      progress |= pass(program);
      assert(ir::validate(program).empty());
    }
  }
}

} // namespace opt

void optimise(ir::Program &program) { opt::run(program); }

} // namespace arbiter::fp
