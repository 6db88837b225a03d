#pragma once
#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/back/llvm/program/prepare.h"

namespace arbiter::fp::llvm_back {

/// Writes the body of \p function, an empty abi::VertexFunction. It loads only input components
/// that are read. It stores the output components that exist (ir::resultMask), with zeros if the
/// program writes none. Requires: \p key has a sampler for each unit that the program samples.
void writeVertex(Code &code, llvm::Function *function, const PreparedVertex &program,
                 const abi::VertexKey &key);

} // namespace arbiter::fp::llvm_back
