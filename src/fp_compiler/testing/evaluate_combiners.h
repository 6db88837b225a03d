#pragma once
#include <array>

#include "fp_compiler/combiners/state.h"

/// An independent implementation of NV_register_combiners and NV_register_combiners2 for tests. It
/// follows the equations of section 3.8.12 stage by stage, in double precision and without the IR.
namespace arbiter::fp::combiners {

using Color = std::array<double, 4>;

/// The inputs of one fragment.
struct Inputs {
  Color primary{}, secondary{};
  std::array<Color, kTextures> textures{};   ///< initial values of the texture registers
  Color fog{};                               ///< the fog colour; its alpha is not read
  double fogFactor = 1.0;                    ///< one if fog is disabled
  std::array<Color, kConstants> constants{}; ///< indexed by globalConstant() and stageConstant()
};

struct Evaluated {
  Color color{}; ///< the final combiner's output, before the framebuffer clamps it
  /// The smallest distance of a mux from its other choice. If it is below a rounding error, the
  /// colour is undetermined.
  double margin = 1.0;
};

/// Computes the colour of a fragment. Undefined registers are zero.
[[nodiscard]] Evaluated evaluate(const State &state, const Inputs &inputs);

} // namespace arbiter::fp::combiners
