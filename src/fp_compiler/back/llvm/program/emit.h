#pragma once
#include <functional>
#include <memory>
#include <string>

#include <llvm/ADT/SmallVector.h>

#include "fp_compiler/back/llvm/code/code.h"

/// From functions of IR to an object file. Each call has an LLVM context of its own, so that any
/// number of threads may compile.
namespace arbiter::fp::llvm_back {

inline constexpr const char *kEntrySymbol = "arbiter_entry";

/// Writes the body of an empty function. False, with a reason, if there is none to be had.
using BodyWriter = std::function<bool(Code &, llvm::Function *, std::string &)>;

enum class Emit { Object, Assembly, Ir };

/// A function of the type of abi::ShadeFunction or abi::VertexFunction (pointers, then a u32) by
/// the name kEntrySymbol: it computes rounded to nearest with denormals as zeros and no traps,
/// whatever the caller's mode is, and calls the body.
/// \return the object's bytes, or text; empty, with a reason, on failure
[[nodiscard]] llvm::SmallVector<char, 0> emit(const Cpu &cpu, int pointers, const BodyWriter &body,
                                              Emit what, std::string &reason);

} // namespace arbiter::fp::llvm_back
