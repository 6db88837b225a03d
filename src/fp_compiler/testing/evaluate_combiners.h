#pragma once
#include <array>

#include "fp_compiler/combiners/state.h"

/// A second reading of NV_register_combiners and 2 for tests: the equations of section 3.8.12,
/// stage by stage, in double precision and without the IR.
namespace arbiter::fp::combiners {

using Color = std::array<double, 4>;

/// One fragment.
struct Inputs {
  Color primary{}, secondary{};
  std::array<Color, kTextures> textures{};   ///< texture registers as they are initialised
  Color fog{};                               ///< the fog colour; its alpha is not read
  double fogFactor = 1.0;                    ///< one where fog is disabled
  std::array<Color, kConstants> constants{}; ///< by globalConstant() and stageConstant()
};

struct Evaluated {
  Color color{}; ///< the final combiner's output, before the framebuffer clamps it
  /// How far a mux was from choosing otherwise; below a rounding error the colour is undetermined.
  double margin = 1.0;
};

/// Undefined registers are zero.
[[nodiscard]] Evaluated evaluate(const State &state, const Inputs &inputs);

} // namespace arbiter::fp::combiners
