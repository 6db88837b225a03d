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
} // namespace

void run(ir::Program &program) {
  bool progress = true;
  while (progress) {
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
