#pragma once
#include <array>
#include <functional>

#include "fp_compiler/ati/lower.h"
#include "fp_compiler/ati/shader.h"

/// A second reading of the specification for tests: runs a shader as tables 3.20 to 3.24 say,
/// pass by pass and pair by pair, without the IR. Single precision, each operation rounded by
/// itself, denormals counted as zero, as the IR's interpreter does.
namespace arbiter::fp::ati {

/// Everything outside a shader that its result depends on. Empty functions give zeros.
struct Inputs {
  std::array<ir::Vec4, kTexCoords> texCoords = {}; ///< (s, t, r, q)
  ir::Vec4 primary = {};
  ir::Vec4 secondary = {};
  /// The value of a constant of kind Env or Local, as it was set.
  std::function<ir::Vec4(const Constant &)> constant;
  /// The texel of an image unit at (s, t, r), divided already.
  std::function<ir::Vec4(int unit, const ir::Vec4 &coordinate)> texture;
};

/// The fragment's colour before fog, colour sum and the clamp of the framebuffer.
/// Requires what lower() requires.
[[nodiscard]] ir::Vec4 evaluate(const Shader &shader, const Inputs &inputs,
                                const LowerOptions &options = {});

} // namespace arbiter::fp::ati
