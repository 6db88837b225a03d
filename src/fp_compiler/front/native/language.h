#pragma once
#include <cstdint>

#include "fp_compiler/native_interface.h"

namespace arbiter::fp::native {

/// The properties in which NVIDIA's own languages differ, as numbers and flags. Their opcodes are
/// in ops.def.
struct Traits {
  ir::NativeLanguage language;
  std::uint8_t registers; ///< R0 and up
  std::uint8_t halves;    ///< H0 and up
  std::uint8_t addresses; ///< A0 and up
  bool addressVectors;    ///< an address register has y, z and w, too
  std::uint16_t rows;     ///< c[0] and up; 0: p[n] and names in their place
  std::int16_t lowest;    ///< the offset from an address register
  std::int16_t highest;
  std::uint16_t instructions; ///< 0: as many as the target's limit says
  bool conditions;            ///< condition codes, bars
  bool plusSigns;             ///< before operands
  bool invariance;            ///< OPTION NV_position_invariant
  const char *nullRegisters;  ///< what takes a result only for its condition code
};

/// Returns the properties of a language.
/// Requires: a language other than None.
[[nodiscard]] const Traits &traitsOf(ir::NativeLanguage language);

/// The number of texture coordinate sets, TEX0 to TEX7.
inline constexpr std::uint32_t kTexCoords = 8;

} // namespace arbiter::fp::native
