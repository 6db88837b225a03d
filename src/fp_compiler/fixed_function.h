#pragma once
#include <array>
#include <cstdint>

#include "fp_compiler/ir/interface.h"

namespace arbiter::fp {

/// The state of fixed function that a program of ATI's fragment shaders is drawn under. Its
/// language names texture units, not targets, and leaves colour sum and fog where they were
/// (ATI_fragment_shader replaces texturing alone; OpenGL 1.3, sections 3.9 and 3.10).
struct FixedFunction {
  std::array<ir::TexTarget, 8> targets = {}; ///< that each texture image unit samples
  /// Units that no texture is enabled on, one bit each: their samples are those of an incomplete
  /// texture, (0,0,0,1).
  std::uint8_t disabledUnits = 0;
  ir::FogMode fog = ir::FogMode::None; ///< FOG's mode where it is enabled
  bool colorSum = false;               ///< COLOR_SUM, or a separate specular colour
  bool operator==(const FixedFunction &) const = default;
};

/// The program to emit for draws under that state: samples have the targets of their units, and the
/// options the fog and colour sum. Colours are clamped to [0,1] before the sum and again before the
/// fog (evaluate() does the same).
[[nodiscard]] ir::Program withFixedFunction(ir::Program program, const FixedFunction &state);

/// The same program as one of language ArbFragment, which has fog options and no colour sum: the
/// code adds the secondary colour itself. For emitAssembly(). Requires a program that
/// withFixedFunction() gave.
[[nodiscard]] ir::Program asArbFragment(ir::Program program);

} // namespace arbiter::fp
