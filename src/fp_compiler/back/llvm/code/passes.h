#pragma once
#include <llvm/IR/Function.h>
#include <llvm/Target/TargetMachine.h>

namespace arbiter::fp::llvm_back {

/// The few passes that a program's code gains by: it comes in SSA form, its programs already
/// optimised (opt/opt.h). No pass changes what is computed.
void optimise(llvm::Function &function, llvm::TargetMachine &machine);

} // namespace arbiter::fp::llvm_back
