#pragma once
#include "fp_compiler/texture_shader/state.h"

namespace arbiter::state {

struct DrawContext;

/// Classifies the texture bound to a target of a unit as texture shaders do: by its base level's
/// internal format and signedness. Returns Base::None if it is not consistent (OpenGL 1.4, 3.8.10:
/// a complete mipmap pyramid if the filter needs one, six matching faces). Queries about ten
/// values. A pyramid found complete counts as complete while its base level and filter are
/// unchanged and no TexImage was called.
[[nodiscard]] fp::texture_shader::Texture boundTexture(DrawContext &context, int unit,
                                                       fp::ir::TexTarget target);

} // namespace arbiter::state
