#pragma once
#include <cstdint>

#include "state/mirror/attributes.h"

/// Generic and conventional vertex attributes of one number as one register (NV_vertex_program,
/// table X.2; ARB_vertex_program leaves it open). Bit n of a mask stands for register n.
namespace arbiter::state {

/// The slot of the conventional attribute that register \p index is; of 0, 1, 6 and 7, which have
/// no conventional name, that of the generic one.
[[nodiscard]] constexpr int slotOfRegister(unsigned index) {
  constexpr unsigned kFirstTexCoord = 8;
  switch (index) {
  case 2:
    return software::kNormal;
  case 3:
    return software::kColor;
  case 4:
    return software::kSecondary;
  case 5:
    return software::kFogCoord;
  default:
    return index < kFirstTexCoord ? software::kGeneric0 + int(index)
                                  : software::kTexCoord0 + int(index - kFirstTexCoord);
  }
}

/// The registers that have both names: all but the position, for which any host has one, and 1, 6
/// and 7, which have no conventional name.
inline constexpr std::uint32_t kAliasedRegisters = 0xFF3C;
[[nodiscard]] constexpr bool isAliasedRegister(unsigned index) {
  return index < 16 && (kAliasedRegisters >> index & 1u) != 0;
}

/// The state of such registers in a context that has NVIDIA's programs, or whose attributes alias.
struct AttributeAliases {
  bool areOne = false; ///< the host's attributes are such registers themselves
  bool ofGlsl =
      false; ///< the application's GLSL shades vertices: it has the two apart (OpenGL 2.1)
  bool immediate = false; ///< what is drawn comes between Begin and End: `arrays` is 0
  /// A command gave the normal, the secondary colour or the fog coordinate components that their
  /// conventional commands do not have, and other values than those leave there.
  bool widerGiven = false;
  std::uint32_t arraysUsed = 0; ///< of generic attributes, enabled once by the application
  std::uint32_t arrays = 0;     ///< of generic attributes, enabled as of the last draw
  /// Arrays that EnableClientState enabled: fixed function has no part in them (NV_vertex_program:
  /// "vertex attribute arrays are IGNORED when vertex program mode is not enabled").
  std::uint32_t ofProgramsAlone = 0;
  bool operator==(const AttributeAliases &) const = default;
};

} // namespace arbiter::state
