#include "fp_compiler/back/llvm/fragment.h"

namespace arbiter::fp::llvm_back {

bool writeFragment(Code &, llvm::Function *, const jit::FragmentProgram &, const abi::FragmentKey &,
                   std::string &reason) {
  reason = "fragment functions are not written yet";
  return false;
}

} // namespace arbiter::fp::llvm_back
