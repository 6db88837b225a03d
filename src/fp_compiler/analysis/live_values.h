#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::analysis {

/// Component masks of temporaries, outputs and address registers.
struct RegisterMasks {
  std::vector<std::uint8_t> temporaries, outputs, addresses;
  bool operator==(const RegisterMasks &) const = default;
};
/// Adds the bits of \p masks to \p to. Requires: both belong to one program.
void add(RegisterMasks &to, const RegisterMasks &masks);

/// The values of a program that reach an output or a KIL, as component masks (bit 0 = x).
struct LiveValues {
  std::vector<std::uint8_t> written;    ///< by instruction: live components; 0 means dead
  std::vector<std::uint8_t> attributes; ///< by attribute: components that are read
  std::vector<std::uint8_t> parameters; ///< by parameter; relative reads do not count
  std::vector<std::uint8_t> outputs;    ///< by output: components that are written
  /// Values that must survive the end of an iteration, by the index of the loop's REP. Code after
  /// the loop reads them, or a later iteration reads them before it writes them.
  std::map<std::size_t, RegisterMasks> kept;
};
/// Returns the live values of \p program. In `written`, KIL, REP, BRK and ENDREP have all four
/// bits.
[[nodiscard]] LiveValues liveOf(const ir::Program &program);

/// Returns \p instruction with the write mask \p written. ir::operandMask() then gives what it
/// reads.
[[nodiscard]] ir::Instruction narrowed(const ir::Instruction &instruction, std::uint8_t written);

} // namespace arbiter::fp::analysis
