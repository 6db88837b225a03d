#pragma once
#include <string>

#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/jit.h"

namespace arbiter::fp::llvm_back {

/// Writes the body of \p function, an empty abi::ShadeFunction: the loops over items,
/// interpolation, the program, and the operations on the fragment after it.
/// \return false, with a reason, if the program and the key cannot be compiled together
[[nodiscard]] bool writeFragment(Code &code, llvm::Function *function,
                                 const jit::FragmentProgram &program, const abi::FragmentKey &key,
                                 std::string &reason);

} // namespace arbiter::fp::llvm_back
