#pragma once
#include "fp_compiler/texture_shader/environment.h"

namespace arbiter::state {

class Context;

/// The texture environments of the host's units, and those that are NONE, which the layer keeps. An
/// environment that NV_texture_shader does not speak of, of another extension, is MODULATE here.
[[nodiscard]] fp::texture_shader::Environments environmentsNow(Context &context);

} // namespace arbiter::state
