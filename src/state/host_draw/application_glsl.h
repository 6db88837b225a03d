#pragma once
#include <GL/gl.h>

#include "state/host_draw/linked_stages.h"

namespace arbiter::state {

class Context;

/// The stages of a program; both if the host does not tell (one loaded by ProgramBinary).
[[nodiscard]] GlslStages stagesOf(Context &context, GLuint program);
/// The stages that a program pipeline has programs for.
[[nodiscard]] GlslStages stagesOfPipeline(Context &context, GLuint pipeline);

} // namespace arbiter::state
