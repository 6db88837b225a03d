#pragma once
#include <optional>

#include <GL/gl.h>

#include "state/objects/linked_stages.h"

namespace arbiter::state {

struct DrawContext;

/// Returns the name to pass to the host for an application's program or shader. If it names an
/// object of the layer's, this is a name that the host does not know.
[[nodiscard]] GLuint guardedName(const DrawContext &context, GLuint name);
/// Returns the name to pass to the host for an application's program pipeline.
[[nodiscard]] GLuint guardedPipeline(const DrawContext &context, GLuint name);
/// Returns the stage of a shader type.
[[nodiscard]] GlslStages stageOf(GLenum shaderType);
/// Returns the stages of the shaders attached to the program now, or nothing if there are none.
[[nodiscard]] std::optional<GlslStages> attachedStages(DrawContext &context, GLuint program);
/// Returns the stages of a program; both if the host does not tell, as for one loaded by
/// ProgramBinary.
[[nodiscard]] GlslStages stagesOf(DrawContext &context, GLuint program);
/// Returns the stages for which a pipeline has programs.
[[nodiscard]] GlslStages stagesOfPipeline(DrawContext &context, GLuint pipeline);

} // namespace arbiter::state
