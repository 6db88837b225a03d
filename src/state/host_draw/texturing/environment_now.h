#pragma once
#include "fp_compiler/texture_shader/environment.h"

namespace arbiter::state {

struct DrawContext;

/// Returns the texture environments of the host's units, and those set to NONE, which the layer
/// keeps. An environment of an extension that NV_texture_shader does not mention counts as
/// MODULATE.
[[nodiscard]] fp::texture_shader::Environments environmentsNow(DrawContext &context);

} // namespace arbiter::state
