#pragma once
#include "state/core/context.h"

namespace arbiter::state {

/// Which program is effective, and how it draws: stage by stage the application's own GLSL wins
/// over ARB programs (ARB_shader_objects), these over ATI's fragment shaders, and these over fixed
/// function. Links what is to be linked, and notes it in `context`; nothing is made current but the
/// host's ARB programs, where they are all that draws. Raises no error.
[[nodiscard]] Path choosePath(Context &context);

/// The application's own GLSL, a program or a pipeline, has a part in draws now, as far as no
/// program of the layer's is bound on the host.
[[nodiscard]] bool applicationShades(Context &context);

} // namespace arbiter::state
