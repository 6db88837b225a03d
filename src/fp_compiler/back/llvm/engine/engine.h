#pragma once
#include <memory>

#include "fp_compiler/back/llvm/code/cpu.h"
#include "fp_compiler/back/llvm/program/emit.h"
#include "fp_compiler/jit.h"

namespace arbiter::fp::llvm_back {

/// The engine that compiles programs for this process (jit.h). Null if this processor is of none of
/// the families, or cannot run the one that is asked for.
[[nodiscard]] std::unique_ptr<jit::Engine> makeEngine(const jit::EngineOptions &options);

} // namespace arbiter::fp::llvm_back
