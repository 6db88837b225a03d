#pragma once
#include <array>
#include <functional>

#include "fp_compiler/texture_shader/state.h"

/// An independent implementation of NV_texture_shader, 2 and 3 for tests. It runs the stages one
/// after the other, as 3.8.13.1 describes them, in double precision. It does not use the IR, and
/// has its own consistency rules.
namespace arbiter::fp::texture_shader {

using Color = std::array<double, 4>;

/// The result of one texture access.
struct Sampled {
  Color texel{}; ///< (R, G, B, A), (HI, LO), or (ds, dt, magnitude, intensity)
  /// The distance of the coordinates from others that give another texel. If it is below a rounding
  /// error, the access is undetermined.
  double margin = 1.0;
};

/// The inputs of one fragment.
struct Inputs {
  std::array<Color, kUnits> coordinates{};              ///< (s, t, r, q)
  std::array<std::array<double, 4>, kUnits> matrices{}; ///< a1 to a4
  std::array<double, kUnits> scales{}, biases{};        ///< OFFSET_TEXTURE_SCALE_NV, BIAS
  std::array<std::array<double, 3>, kUnits> eyes{};     ///< CONST_EYE_NV
  double near = 0.0, far = 1.0;                         ///< the depth range
  /// Returns the texel of a unit's target at (s, t, r), in the unit's own components.
  std::function<Sampled(int unit, const std::array<double, 3> &at)> sample;
};

struct Evaluated {
  std::array<Color, kUnits> colors{};    ///< texture unit RGBA results
  std::array<bool, kUnits> consistent{}; ///< SHADER_CONSISTENT_NV
  std::array<Base, kUnits>
      environment{}; ///< the base format that a texture environment uses; None: it passes
  bool discarded = false;
  bool replacesDepth = false;
  bool depthOutOfRange = false; ///< outside of the depth range, so the fragment is discarded
  double depth = 0.0;
  double margin = 1.0; ///< the smallest of all accesses and comparisons
};

[[nodiscard]] Evaluated evaluate(const State &state, const Inputs &inputs);

/// Returns a unit's texture register of register combiners (NV_register_combiners, table 2).
[[nodiscard]] Color registerOf(const Evaluated &evaluated, int unit);

} // namespace arbiter::fp::texture_shader
