#pragma once
#include "fp_compiler/back/llvm/fragment/fragment_hooks.h"

namespace arbiter::fp::llvm_back {

/// The program's options over its colours: the colour sum, then fog (ir/semantics.h, Options).
void applyOptions(Code &code, const Places &places, Value *data, const ir::Options &options,
                  Numerics numerics, FragmentHooks &hooks, FragmentColors &fragment);

} // namespace arbiter::fp::llvm_back
