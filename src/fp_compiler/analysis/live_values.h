#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::analysis {

/// What of a program reaches an output or a KIL, by component masks (bit 0 = x).
struct LiveValues {
  std::vector<std::uint8_t> written;    ///< by instruction: its components that count; 0: leave out
  std::vector<std::uint8_t> attributes; ///< by attribute: components that are read
  std::vector<std::uint8_t> parameters; ///< by row, relative reads not counted
  std::vector<std::uint8_t> outputs;    ///< by output: components that are written
};
/// KIL's entry in `written` is all four.
[[nodiscard]] LiveValues liveOf(const ir::Program &program);

/// The instruction as if its mask were \p written: what it then reads is ir::operandMask's.
[[nodiscard]] ir::Instruction narrowed(const ir::Instruction &instruction, std::uint8_t written);

} // namespace arbiter::fp::analysis
