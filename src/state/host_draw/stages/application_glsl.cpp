// Finds out which stages the application's own GLSL programs and pipelines leave to ARB programs.
#include "state/host_draw/stages/application_glsl.h"

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/stages/stage_pipeline.h"
#include "state/programs/program_bind.h"
#include "state/share/share_group.h"

namespace arbiter::state {

GlslStages stageOf(GLenum shaderType) {
  return {shaderType == GL_VERTEX_SHADER, shaderType == GL_FRAGMENT_SHADER};
}

namespace {
/// A name that no host gives, so it is unknown, as the layer's objects must seem to be.
constexpr GLuint kUnknown = 0xFFFFFFF0u;
} // namespace

GLuint guardedName(const DrawContext &context, GLuint name) {
  return context.group && context.group->ownsHostProgram(name) ? kUnknown : name;
}

GLuint guardedPipeline(const DrawContext &context, GLuint name) {
  return context.hostSide.stagePipeline && context.hostSide.stagePipeline->owns(name) ? kUnknown
                                                                                      : name;
}

std::optional<GlslStages> attachedStages(DrawContext &context, GLuint program) {
  constexpr GLsizei kMaxShaders = 32;
  GLuint shaders[kMaxShaders] = {};
  GLsizei count = 0;
  const HostErrorScope scope(*context.host, context.errors.pending);
  context.host->GetAttachedShaders(program, kMaxShaders, &count, shaders);
  GlslStages stages;
  for (GLsizei i = 0; i < count; ++i) {
    GLint type = 0;
    context.host->GetShaderiv(shaders[i], GL_SHADER_TYPE, &type);
    const GlslStages stage = stageOf(GLenum(type));
    stages.vertex |= stage.vertex;
    stages.fragment |= stage.fragment;
  }
  return count > 0 ? std::optional(stages) : std::nullopt;
}

GlslStages stagesOf(DrawContext &context, GLuint program) {
  if (const auto known = context.group->linkedStages.of(*context.host, program))
    return *known;
  return attachedStages(context, program).value_or(GlslStages{true, true});
}

GlslStages stagesOfPipeline(DrawContext &context, GLuint pipeline) {
  GLint vertex = 0, fragment = 0;
  const HostErrorScope scope(*context.host, context.errors.pending);
  context.host->GetProgramPipelineiv(pipeline, GL_VERTEX_SHADER, &vertex);
  context.host->GetProgramPipelineiv(pipeline, GL_FRAGMENT_SHADER, &fragment);
  return {vertex != 0, fragment != 0};
}

} // namespace arbiter::state
