#pragma once
#include <cstdint>

#include "state/mirror/attributes.h"

/// Generic and conventional vertex attributes of the same number that are one register
/// (NV_vertex_program, table X.2; ARB_vertex_program leaves it open). Bit n of a mask stands for
/// register n.
namespace arbiter::state {

/// Returns the slot of register \p index: the conventional attribute's, or the generic one's for 0,
/// 1, 6 and 7, which have no conventional name.
[[nodiscard]] constexpr int slotOfRegister(unsigned index) {
  constexpr unsigned kFirstTexCoord = 8;
  switch (index) {
  case 2:
    return kNormal;
  case 3:
    return kColor;
  case 4:
    return kSecondary;
  case 5:
    return kFogCoord;
  default:
    return index < kFirstTexCoord ? kGeneric0 + int(index)
                                  : kTexCoord0 + int(index - kFirstTexCoord);
  }
}

/// The registers that alias. Registers 1, 6 and 7 have no conventional name, and every host aliases
/// the position itself.
inline constexpr std::uint32_t kAliasedRegisters = 0xFF3C;
[[nodiscard]] constexpr bool isAliasedRegister(unsigned index) {
  return index < 16 && (kAliasedRegisters >> index & 1u) != 0;
}

/// Aliasing state of a context that has NVIDIA's programs, or whose attributes alias.
struct AttributeAliases {
  bool areOne = false; ///< the host's attributes alias by themselves
  bool ofGlsl =
      false; ///< the application's GLSL shades vertices, where attributes do not alias (OpenGL 2.1)
  bool immediate = false; ///< the draw is Begin and End, so `arrays` is 0
  /// The application set a component of the normal, secondary colour or fog coordinate that the
  /// conventional command lacks, and not to its default.
  bool widerGiven = false;
  std::uint32_t arraysUsed = 0; ///< generic arrays that the application ever enabled
  std::uint32_t arrays = 0;     ///< generic arrays that are enabled, as of the last draw
  /// Arrays enabled by EnableClientState. Fixed function ignores them (NV_vertex_program: "vertex
  /// attribute arrays are IGNORED when vertex program mode is not enabled").
  std::uint32_t ofProgramsAlone = 0;
  bool operator==(const AttributeAliases &) const = default;
};

} // namespace arbiter::state
