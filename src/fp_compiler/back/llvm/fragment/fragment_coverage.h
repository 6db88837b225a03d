#pragma once
#include "fp_compiler/back/llvm/fragment/fragment_hooks.h"

namespace arbiter::fp::llvm_back {

/// Applies coverage other than Whole to the colours' alpha and to the live fragments.
/// \param input the coverage input
void applyCoverage(Code &code, abi::Coverage coverage, const Vec &input, FragmentColors &fragment);

} // namespace arbiter::fp::llvm_back
