#pragma once
#include <epoxy/gl.h>

#include "fp_compiler/texture_shader/environment.h"

namespace shaded {

/// The stages of units 0 to `state.units` - 1 as TexEnv sets them; of a conventional state the
/// texture targets that are enabled.
void issue(const arbiter::fp::texture_shader::State &state);
void issue(const arbiter::fp::texture_shader::Environments &environments, int units);
/// Register combiners show half of a unit's colour and one half.
void showUnit(int unit);

/// The target that an operation samples; 0: none.
[[nodiscard]] GLenum targetOf(arbiter::fp::texture_shader::Operation operation);

} // namespace shaded
