#pragma once
#include "fp_compiler/back/llvm/fragment/fragment_hooks.h"

namespace arbiter::fp::llvm_back {

/// The program's options over its colours: the colour sum, then fog (ir/semantics.h, Options).
void applyOptions(Code &code, const Places &places, Value *data, const ir::Options &options,
                  Numerics numerics, FragmentHooks &hooks, FragmentColors &fragment);

/// Coverage that is not Whole over the colours' alpha, and over what of the fragments is alive.
/// \param input its own
void applyCoverage(Code &code, abi::Coverage coverage, const Vec &input, FragmentColors &fragment);

} // namespace arbiter::fp::llvm_back
