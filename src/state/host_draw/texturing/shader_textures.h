#pragma once
#include "fp_compiler/texture_shader/state.h"

namespace arbiter::state {

class Context;

/// What is bound to a target of a unit, as texture shaders tell textures apart: the base internal
/// format and the signedness of its base level; Base::None where it is not consistent (OpenGL 1.4,
/// 3.8.10: a mipmap pyramid where the filter wants one, six faces that match). Asks the host some
/// ten values. A pyramid that was found whole is taken for it as long as its base level and its
/// filter are the same and no TexImage has come.
[[nodiscard]] fp::texture_shader::Texture boundTexture(Context &context, int unit,
                                                       fp::ir::TexTarget target);

} // namespace arbiter::state
