#pragma once
#include <llvm/IR/Function.h>
#include <llvm/Target/TargetMachine.h>

namespace arbiter::fp::llvm_back {

/// Runs the few LLVM passes that improve a program's code. The code is in SSA form, and its program
/// is optimised already (opt/opt.h). No pass changes results.
void optimise(llvm::Function &function, llvm::TargetMachine &machine);

} // namespace arbiter::fp::llvm_back
