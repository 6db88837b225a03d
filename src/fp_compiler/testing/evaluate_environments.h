#pragma once
#include "fp_compiler/testing/evaluate_texture_shaders.h"
#include "fp_compiler/texture_shader/environment.h"

namespace arbiter::fp::texture_shader {

/// Texture environments by the tables of NV_texture_shader 3.8.9, in double precision: the colour
/// after those of all units. `texels` are texture unit RGBA results, `bases` what they are taken
/// for.
[[nodiscard]] Color evaluateEnvironments(const Environments &environments,
                                         const std::array<Base, kUnits> &bases,
                                         const std::array<Color, kUnits> &texels,
                                         const std::array<Color, kUnits> &constants,
                                         const Color &primary);

} // namespace arbiter::fp::texture_shader
