#pragma once
#include <functional>
#include <memory>
#include <string>

#include <llvm/ADT/SmallVector.h>

#include "fp_compiler/back/llvm/code/code.h"

/// Compiles a function of LLVM IR to an object file. Each call has its own LLVM context, so that
/// several threads may compile at once.
namespace arbiter::fp::llvm_back {

inline constexpr const char *kEntrySymbol = "arbiter_entry";

/// Writes the body of an empty function. Returns false, with a reason, if that is impossible.
using BodyWriter = std::function<bool(Code &, llvm::Function *, std::string &)>;

enum class Emit { Object, Assembly, Ir };

/// Compiles a function with the type of abi::ShadeFunction or abi::VertexFunction (pointers, then a
/// u32) and the name kEntrySymbol. It sets rounding to nearest, denormals as zeros and no traps,
/// whatever the caller's mode is, and calls the body.
/// \return the object's bytes, or text; empty, with a reason, on failure
[[nodiscard]] llvm::SmallVector<char, 0> emit(const Cpu &cpu, int pointers, const BodyWriter &body,
                                              Emit what, std::string &reason);

} // namespace arbiter::fp::llvm_back
