#pragma once
#include <memory>

#include "fp_compiler/back/llvm/code/cpu.h"
#include "fp_compiler/back/llvm/program/emit.h"
#include "fp_compiler/jit.h"

namespace arbiter::fp::llvm_back {

/// Returns the engine that compiles programs for this process (jit.h). Null if this processor
/// belongs to no supported family, or cannot run the requested one.
[[nodiscard]] std::unique_ptr<jit::Engine> makeEngine(const jit::EngineOptions &options);

} // namespace arbiter::fp::llvm_back
