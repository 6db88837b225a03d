#pragma once
#include <string>

#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/jit.h"

namespace arbiter::fp::llvm_back {

/// Writes the body of \p function, an abi::ShadeFunction that is empty yet: loops over the items,
/// interpolation, the program, and what happens to the fragment after it.
/// \return false, with a reason, where the program and the key cannot be compiled together
[[nodiscard]] bool writeFragment(Code &code, llvm::Function *function,
                                 const jit::FragmentProgram &program, const abi::FragmentKey &key,
                                 std::string &reason);

} // namespace arbiter::fp::llvm_back
