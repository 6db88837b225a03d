#pragma once
#include <array>
#include <cstdint>

#include "fp_compiler/ir/interface.h"

namespace arbiter::fp {

/// The fixed-function state that an ATI fragment shader is drawn under. The language names texture
/// units, not targets. It replaces only texturing, so colour sum and fog stay with fixed function
/// (ATI_fragment_shader; OpenGL 1.3, sections 3.9 and 3.10).
struct FixedFunction {
  std::array<ir::TexTarget, 8> targets = {}; ///< the target of each texture image unit
  /// A bit for each unit without an enabled texture. Its samples are those of an incomplete
  /// texture, (0,0,0,1).
  std::uint8_t disabledUnits = 0;
  ir::FogMode fog = ir::FogMode::None; ///< the mode of FOG if it is enabled
  bool colorSum = false;               ///< COLOR_SUM, or a separate specular colour
  bool operator==(const FixedFunction &) const = default;
};

/// Returns the program to emit for draws under the state. Samples get the targets of their units,
/// and the options get fog and colour sum. Colours are clamped to [0,1] before the sum and again
/// before the fog, as in evaluate().
[[nodiscard]] ir::Program withFixedFunction(ir::Program program, const FixedFunction &state);

/// Returns the program in the language ArbFragment, which has fog options but no colour sum. Its
/// code adds the secondary colour itself. For emitAssembly().
/// Requires: withFixedFunction() gave the program.
[[nodiscard]] ir::Program asArbFragment(ir::Program program);

} // namespace arbiter::fp
