#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// Data flow in a straight-line program: finds dead code, dependent reads and live registers.
namespace arbiter::fp::hw {

inline constexpr std::uint32_t kNoInstruction = 0xFFFFFFFF;

/// For each instruction: the instructions it depends on, and whether a result depends on it.
struct Dataflow {
  /// Element [o][c] is the instruction that last wrote what component c of operand o reads, after
  /// its swizzle. It is kNoInstruction if that is not a temporary, was not written, or is not used.
  using Writers = std::array<std::array<std::uint32_t, 4>, 3>;
  std::vector<Writers> writers; ///< by instruction
  /// By instruction: true if a result or a KIL depends on it.
  std::vector<bool> live;
};

/// Computes writers and liveness.
/// Requires: validate(program) finds nothing.
[[nodiscard]] Dataflow dataflowOf(const ir::Program &program);

/// Returns the longest chain of texture samples that depend on each other, with the instructions
/// between them, in order (NativeReport::chain). Leaves dead instructions out.
[[nodiscard]] std::vector<std::uint32_t> longestChain(const ir::Program &program,
                                                      const Dataflow &flow);

/// Returns the largest number of registers that hold a value at once. Each live temporary takes
/// one, and each result keeps one from its first write. Leaves dead instructions out.
[[nodiscard]] std::uint32_t registersAtOnce(const ir::Program &program, const Dataflow &flow);

} // namespace arbiter::fp::hw
