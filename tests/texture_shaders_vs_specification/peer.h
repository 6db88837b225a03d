#pragma once
#include "fp_compiler/texture_shader/environment.h"

/// What NVIDIA's driver does otherwise (docs/write/texture_shaders.md, "Where NVIDIA's driver
/// answers otherwise") is left out of random states.
namespace shaded {

/// Stages that the driver takes otherwise become the nearest that it does not.
void leaveOut(arbiter::fp::texture_shader::State &state);
/// The same of the environments behind them.
void leaveOut(const arbiter::fp::texture_shader::State &state,
              arbiter::fp::texture_shader::Environments &environments);

} // namespace shaded
