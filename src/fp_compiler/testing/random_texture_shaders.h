#pragma once
#include <cstdint>

#include "fp_compiler/testing/random.h"
#include "fp_compiler/texture_shader/environment.h"
#include "fp_compiler/texture_shader/state.h"

/// Random stages of NV_texture_shader, 2 and 3, as the commands can set them, from a seed and the
/// same on every machine.
namespace arbiter::fp::testing {

/// Stages for `units` units. Most of them fit what is before them, so that long chains are
/// consistent; some do not.
[[nodiscard]] texture_shader::State randomTextureShaders(Random &random, int units);

/// Random texture environments of `units` units.
[[nodiscard]] texture_shader::Environments randomEnvironments(Random &random, int units);

/// What the texture of a stage's target may be, for a stage that another may read.
[[nodiscard]] texture_shader::Texture randomTexture(Random &random);

} // namespace arbiter::fp::testing
