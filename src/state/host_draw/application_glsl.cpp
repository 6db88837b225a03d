// The application's own GLSL programs and pipelines: which stages they leave to ARB programs.
#include "state/host_draw/application_glsl.h"

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/core/share_group.h"
#include "state/host_draw/draw.h"
#include "state/programs/program_api.h"

namespace arbiter::state {

namespace {

void add(GlslStages &stages, GLenum shaderType) {
  stages.vertex |= shaderType == GL_VERTEX_SHADER;
  stages.fragment |= shaderType == GL_FRAGMENT_SHADER;
}

/// Of the shaders that are attached now; empty if there are none.
std::optional<GlslStages> attachedStages(Context &context, GLuint program) {
  constexpr GLsizei kMaxShaders = 32;
  GLuint shaders[kMaxShaders] = {};
  GLsizei count = 0;
  const HostErrorScope scope(*context.host, context.pendingError);
  context.host->GetAttachedShaders(program, kMaxShaders, &count, shaders);
  GlslStages stages;
  for (GLsizei i = 0; i < count; ++i) {
    GLint type = 0;
    context.host->GetShaderiv(shaders[i], GL_SHADER_TYPE, &type);
    add(stages, GLenum(type));
  }
  return count > 0 ? std::optional(stages) : std::nullopt;
}

/// A program that is linked while it is current is effective as it is linked then. Mesa 22.3 takes
/// up only those stages that it had before.
void takeUpExecutable(Context &context, GLuint program) {
  if (context.listMode != 0 || context.insideBeginEnd || context.hostProgramIsOurs)
    return;
  GLint current = 0;
  context.host->GetIntegerv(GL_CURRENT_PROGRAM, &current);
  if (GLuint(current) != program || program == 0)
    return;
  const HostErrorScope scope(*context.host,
                             context.pendingError); // where the link failed it stays as it was
  context.host->UseProgram(program);
}

} // namespace

GlslStages stagesOf(Context &context, GLuint program) {
  if (const auto known = context.group->linkedStages.of(*context.host, program))
    return *known;
  return attachedStages(context, program).value_or(GlslStages{true, true});
}

GlslStages stagesOfPipeline(Context &context, GLuint pipeline) {
  GLint vertex = 0, fragment = 0;
  const HostErrorScope scope(*context.host, context.pendingError);
  context.host->GetProgramPipelineiv(pipeline, GL_VERTEX_SHADER, &vertex);
  context.host->GetProgramPipelineiv(pipeline, GL_FRAGMENT_SHADER, &fragment);
  return {vertex != 0, fragment != 0};
}

namespace handlers {

void LinkProgram(Context &context, GLuint program) {
  program = guardName(context, program);
  // Before the link: it may leave an error, which is the application's.
  const auto attached = attachedStages(context, program);
  context.host->LinkProgram(program);
  if (attached)
    context.group->linkedStages.linked(program, *attached);
  invalidateProgram(context); // its executable may be effective
  takeUpExecutable(context, program);
}

void ProgramBinary(Context &context, GLuint program, GLenum binaryFormat, const void *binary,
                   GLsizei length) {
  program = guardName(context, program);
  context.group->linkedStages.forget(program);
  context.host->ProgramBinary(program, binaryFormat, binary, length);
  invalidateProgram(context);
}

GLuint CreateShaderProgramv(Context &context, GLenum type, GLsizei count,
                            const GLchar *const *strings) {
  const GLuint program = context.host->CreateShaderProgramv(type, count, strings);
  GlslStages stages;
  add(stages, type);
  if (program != 0)
    context.group->linkedStages.set(program, stages);
  return program;
}

void BindProgramPipeline(Context &context, GLuint pipeline) {
  if (context.hostProgramIsOurs && !context.listMode)
    releaseHostState(context);
  context.host->BindProgramPipeline(pipeline);
  context.pipelinesUsed = true;
  invalidateProgram(context);
}

void UseProgramStages(Context &context, GLuint pipeline, GLbitfield stages, GLuint program) {
  context.host->UseProgramStages(pipeline, stages, guardName(context, program));
  invalidateProgram(context);
}

} // namespace handlers
} // namespace arbiter::state
