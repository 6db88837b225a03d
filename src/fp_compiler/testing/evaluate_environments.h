#pragma once
#include "fp_compiler/testing/evaluate_texture_shaders.h"
#include "fp_compiler/texture_shader/environment.h"

namespace arbiter::fp::texture_shader {

/// Computes texture environments by the tables of NV_texture_shader 3.8.9, in double precision.
/// Returns the colour after all units.
/// \param texels texture unit RGBA results
/// \param bases the base formats that the environments use for them
[[nodiscard]] Color evaluateEnvironments(const Environments &environments,
                                         const std::array<Base, kUnits> &bases,
                                         const std::array<Color, kUnits> &texels,
                                         const std::array<Color, kUnits> &constants,
                                         const Color &primary);

} // namespace arbiter::fp::texture_shader
