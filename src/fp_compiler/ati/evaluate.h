#pragma once
#include <array>
#include <functional>

#include "fp_compiler/ati/lower.h"
#include "fp_compiler/ati/shader.h"

/// A second implementation of the specification for tests. It runs a shader pass by pass and pair
/// by pair as tables 3.20 to 3.24 say, without the IR. Arithmetic is single precision. Each
/// operation is rounded, and denormals count as zero, as in the IR's interpreter.
namespace arbiter::fp::ati {

/// All inputs of a shader. Empty functions give zeros.
struct Inputs {
  std::array<ir::Vec4, kTexCoords> texCoords = {}; ///< (s, t, r, q)
  ir::Vec4 primary = {};
  ir::Vec4 secondary = {};
  /// Returns the value of a constant of kind Env or Local as it was set.
  std::function<ir::Vec4(const Constant &)> constant;
  /// Returns the texel of an image unit at (s, t, r), which is already divided.
  std::function<ir::Vec4(int unit, const ir::Vec4 &coordinate)> texture;
};

/// Returns the fragment's colour before fog, colour sum and the framebuffer's clamp. Requires: as
/// for lower().
[[nodiscard]] ir::Vec4 evaluate(const Shader &shader, const Inputs &inputs,
                                const LowerOptions &options = {});

} // namespace arbiter::fp::ati
