#include "fp_compiler/back/llvm/engine.h"

/// What the library exports (jit.h).
extern "C" __attribute__((visibility("default"))) arbiter::fp::jit::Engine *
arbiter_jit_engine(const arbiter::fp::jit::EngineOptions *options) {
  try {
    return arbiter::fp::llvm_back::makeEngine(*options).release();
  } catch (...) {
    return nullptr;
  }
}
