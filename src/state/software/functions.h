#pragma once
#include <atomic>
#include <memory>

#include "fp_compiler/abi.h"
#include "fp_compiler/jit.h"

/// The process's machine code: the engine, made when first wanted, and the functions by program and
/// key. Functions are compiled on a thread of their own; until one is ready the host draws.
namespace arbiter::state {
struct CompiledProgram;
}

namespace arbiter::state::software {

/// The engine, or null where the library does not load (said once in the log).
[[nodiscard]] fp::jit::Engine *engine();

/// One program as the JIT sees it; made at its first draw, kept with the CompiledProgram.
struct FragmentFunctions;
struct VertexFunctions;

/// A function that is being made. ready() is one load.
template <typename Function> struct Pending {
  std::atomic<Function> function{nullptr};
  std::atomic<bool> failed{false};
};

/// The program prepared, or null while that is being done, or where it cannot be (`failed`).
/// \param wait compile on this thread and return the result (ARBITER_BACKEND=swrast)
[[nodiscard]] const fp::jit::FragmentProgram *
prepared(const std::shared_ptr<const CompiledProgram> &program, fp::Numerics numerics, bool wait,
         bool &failed);
[[nodiscard]] abi::ShadeFunction function(const std::shared_ptr<const CompiledProgram> &program,
                                          fp::Numerics numerics, const abi::FragmentKey &key,
                                          bool wait, bool &failed);

/// A vertex program: an application's, or fixed function's, written as IR and named by its key.
[[nodiscard]] const fp::jit::VertexProgram *
prepareVertex(const std::shared_ptr<const fp::ir::Program> &program, fp::Numerics numerics,
              bool wait, bool &failed);
[[nodiscard]] abi::VertexFunction vertexFunction(const fp::jit::VertexProgram &program, bool wait,
                                                 bool &failed);

/// Ends the compiling thread: before the library is left, and in a child after fork.
void stopCompiling();

} // namespace arbiter::state::software
