#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// Who wrote what in a straight-line program: for dead code, dependent reads and live registers.
namespace arbiter::fp::hw {

inline constexpr std::uint32_t kNoInstruction = 0xFFFFFFFF;

struct Dataflow {
  /// Of operand o, by the component that the operand hands on (before the swizzle): the
  /// instruction that last wrote what it reads, kNoInstruction where that is no temporary, was not
  /// written, or does not matter.
  using Writers = std::array<std::array<std::uint32_t, 4>, 3>;
  std::vector<Writers> writers; ///< by instruction
  /// By instruction: whether a result or a KIL depends on it.
  std::vector<bool> live;
};

[[nodiscard]] Dataflow dataflowOf(const ir::Program &program);

/// The longest chain of texture samples that depend on each other, with what stands between, in
/// order (NativeReport::chain). Dead instructions are left out.
[[nodiscard]] std::vector<std::uint32_t> longestChain(const ir::Program &program,
                                                      const Dataflow &flow);

/// The most registers that hold a value at once, if each temporary that is live has one and each
/// result keeps one from its first write on. Dead instructions are left out.
[[nodiscard]] std::uint32_t registersAtOnce(const ir::Program &program, const Dataflow &flow);

} // namespace arbiter::fp::hw
