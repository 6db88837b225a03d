#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// Who wrote what in a straight-line program: for dead code, dependent reads and live registers.
namespace arbiter::fp::hw {

inline constexpr std::uint32_t kNoInstruction = 0xFFFFFFFF;

/// For each instruction: which ones it depends on, and whether anything depends on it.
struct Dataflow {
  /// [o][c]: the instruction that last wrote what component c of operand o, after its swizzle,
  /// reads; kNoInstruction where that is no temporary, was not written, or is not used.
  using Writers = std::array<std::array<std::uint32_t, 4>, 3>;
  std::vector<Writers> writers; ///< by instruction
  /// By instruction: whether a result or a KIL depends on it.
  std::vector<bool> live;
};

/// Requires: validate(program) finds nothing.
[[nodiscard]] Dataflow dataflowOf(const ir::Program &program);

/// The longest chain of texture samples that depend on each other, with what stands between, in
/// order (NativeReport::chain). Dead instructions are left out.
[[nodiscard]] std::vector<std::uint32_t> longestChain(const ir::Program &program,
                                                      const Dataflow &flow);

/// The most registers that hold a value at once, if each temporary that is live has one and each
/// result keeps one from its first write on. Dead instructions are left out.
[[nodiscard]] std::uint32_t registersAtOnce(const ir::Program &program, const Dataflow &flow);

} // namespace arbiter::fp::hw
