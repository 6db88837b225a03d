#pragma once
#include "fp_compiler/texture_shader/environment.h"

/// Removes from random states what NVIDIA's driver does differently (docs/write/texture_shaders.md,
/// "Where NVIDIA's driver answers otherwise").
namespace shaded {

/// Replaces stages that the driver treats differently by the nearest ones that it does not.
void leaveOut(arbiter::fp::texture_shader::State &state);
/// Does the same for the environments behind the stages.
void leaveOut(const arbiter::fp::texture_shader::State &state,
              arbiter::fp::texture_shader::Environments &environments);

} // namespace shaded
