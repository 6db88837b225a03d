#pragma once
#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/back/llvm/program/prepare.h"

namespace arbiter::fp::llvm_back {

/// Writes the body of \p function, an abi::VertexFunction that is empty yet. Of an input only the
/// components that are read are asked for; of an output those that count (ir::resultMask) are
/// written, with zeros where the program writes none. \p key has a sampler for each unit that the
/// program samples.
void writeVertex(Code &code, llvm::Function *function, const PreparedVertex &program,
                 const abi::VertexKey &key);

} // namespace arbiter::fp::llvm_back
