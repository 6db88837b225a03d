#pragma once
#include <optional>

#include <GL/gl.h>

#include "state/objects/linked_stages.h"

namespace arbiter::state {

class Context;

/// A name of the application's for a program or shader as the host may be given it: where it is
/// one of the layer's objects, a name that the host does not know.
[[nodiscard]] GLuint guardedName(const Context &context, GLuint name);
/// The same of program pipelines.
[[nodiscard]] GLuint guardedPipeline(const Context &context, GLuint name);
/// The stage of a shader of that type.
[[nodiscard]] GlslStages stageOf(GLenum shaderType);
/// The stages of the shaders that are attached to the program now; empty if there are none.
[[nodiscard]] std::optional<GlslStages> attachedStages(Context &context, GLuint program);
/// The stages of a program; both if the host does not tell (one loaded by ProgramBinary).
[[nodiscard]] GlslStages stagesOf(Context &context, GLuint program);
/// The stages that a program pipeline has programs for.
[[nodiscard]] GlslStages stagesOfPipeline(Context &context, GLuint pipeline);

} // namespace arbiter::state
