#pragma once
#include "fp_compiler/abi.h"
#include "fp_compiler/ir/ir.h"

/// What machine code of a program costs to make, estimated from the program alone, so that a
/// program that would keep a draw waiting is the host's at once and LLVM is never asked.
namespace arbiter::fp::llvm_back {

/// More than this is not begun: a compilation cannot be interrupted, and a draw, a thread or the
/// process that ends may have to wait for it.
inline constexpr double kMostMilliseconds = 500;

/// Of one processor's time. LLVM's register allocation and scheduling take the square of a long
/// function's length. Measured over chains in which every result is used again, which is the worst
/// that there is, so that most programs take less.
/// \param key of a fragment function; null: a vertex program
[[nodiscard]] double expectedMilliseconds(const ir::Program &program, const abi::FragmentKey *key);

} // namespace arbiter::fp::llvm_back
