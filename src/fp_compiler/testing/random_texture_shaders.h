#pragma once
#include <cstdint>

#include "fp_compiler/testing/random.h"
#include "fp_compiler/texture_shader/environment.h"
#include "fp_compiler/texture_shader/state.h"

/// Random stages of NV_texture_shader, 2 and 3 that the commands can set. A seed gives the same
/// stages on every machine.
namespace arbiter::fp::testing {

/// Returns stages for `units` units. Most of them fit the stages before them, so that long chains
/// are consistent.
[[nodiscard]] texture_shader::State randomTextureShaders(Random &random, int units);

/// Returns texture environments for `units` units.
[[nodiscard]] texture_shader::Environments randomEnvironments(Random &random, int units);

/// Returns a texture for a stage's target.
[[nodiscard]] texture_shader::Texture randomTexture(Random &random);

} // namespace arbiter::fp::testing
