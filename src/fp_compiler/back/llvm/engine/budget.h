#pragma once
#include "fp_compiler/abi.h"
#include "fp_compiler/ir/ir.h"

/// Estimates the cost of compiling a program, from the program alone. Draws with a program that is
/// too expensive go to the host at once, and LLVM does not start.
namespace arbiter::fp::llvm_back {

/// The samplers of a key, by unit.
using SamplerKeys = std::array<abi::SamplerKey, abi::kMaxUnits>;

/// Maximum expected time of a compilation. It cannot be interrupted, and a draw, a thread or
/// process exit may have to wait for it.
inline constexpr double kMaxMilliseconds = 500;

/// Returns the expected time on one processor. The cost of LLVM's register allocation and
/// scheduling is quadratic in the length of the function. The constants were measured on chains in
/// which every result is used again, which is the worst case. Most programs take less.
/// \param samplers the key's samplers; null counts no sampling
[[nodiscard]] double expectedMilliseconds(const ir::Program &program, const SamplerKeys *samplers);

} // namespace arbiter::fp::llvm_back
