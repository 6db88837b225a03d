#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::analysis {

/// Components of registers, a mask each: of temporaries, outputs and address registers.
struct RegisterMasks {
  std::vector<std::uint8_t> temporaries, outputs, addresses;
  bool operator==(const RegisterMasks &) const = default;
};
/// Those of both. Requires: both are of one program.
void add(RegisterMasks &to, const RegisterMasks &masks);

/// What of a program reaches an output or a KIL, by component masks (bit 0 = x).
struct LiveValues {
  std::vector<std::uint8_t> written;    ///< by instruction: its components that count; 0: leave out
  std::vector<std::uint8_t> attributes; ///< by attribute: components that are read
  std::vector<std::uint8_t> parameters; ///< by row, relative reads not counted
  std::vector<std::uint8_t> outputs;    ///< by output: components that are written
  /// By REP's index: what is read after the loop or in an iteration that has not written it, so
  /// that it must be kept when an iteration ends.
  std::map<std::size_t, RegisterMasks> kept;
};
/// The entry in `written` of KIL and of what begins, ends and leaves loops is all four.
[[nodiscard]] LiveValues liveOf(const ir::Program &program);

/// The instruction as if its mask were \p written: what it then reads is ir::operandMask's.
[[nodiscard]] ir::Instruction narrowed(const ir::Instruction &instruction, std::uint8_t written);

} // namespace arbiter::fp::analysis
