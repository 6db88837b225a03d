#pragma once
#include <epoxy/gl.h>

#include "fp_compiler/texture_shader/environment.h"

namespace shaded {

/// Sets the stages of units 0 to `state.units` - 1 by TexEnv; for a conventional state, enables its
/// texture targets.
void issue(const arbiter::fp::texture_shader::State &state);
void issue(const arbiter::fp::texture_shader::Environments &environments, int units);
/// Sets register combiners that show half of a unit's color plus one half.
void showUnit(int unit);

/// Returns the target that an operation samples; 0: none.
[[nodiscard]] GLenum targetOf(arbiter::fp::texture_shader::Operation operation);

} // namespace shaded
