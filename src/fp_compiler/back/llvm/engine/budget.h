#pragma once
#include "fp_compiler/abi.h"
#include "fp_compiler/ir/ir.h"

/// What machine code of a program costs to make, estimated from the program alone, so that a
/// program that would keep a draw waiting is the host's at once and LLVM is never asked.
namespace arbiter::fp::llvm_back {

/// Of a key, by unit.
using SamplerKeys = std::array<abi::SamplerKey, abi::kMaxUnits>;

/// More than this is not begun: a compilation cannot be interrupted, and a draw, a thread or the
/// process that ends may have to wait for it.
inline constexpr double kMostMilliseconds = 500;

/// Of one processor's time. LLVM's register allocation and scheduling take the square of a long
/// function's length. Measured over chains in which every result is used again, which is the worst
/// that there is, so that most programs take less.
/// \param samplers of the key; null: as if nothing were sampled
[[nodiscard]] double expectedMilliseconds(const ir::Program &program, const SamplerKeys *samplers);

} // namespace arbiter::fp::llvm_back
