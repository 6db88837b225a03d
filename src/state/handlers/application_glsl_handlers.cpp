// Commands on the application's own GLSL programs and pipelines, and the attribute stack. Each may
// change which program shades.
#include <algorithm>
#include <vector>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/fixed_function.h"
#include "state/host_draw/stages/application_glsl.h"
#include "state/host_draw/stages/stage_pipeline.h"
#include "state/host_draw/use_program.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_bind.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Makes a newly linked current program effective, with UseProgram. Linking alone should do that,
/// but Mesa 22.3 then adopts only the stages that the program had before.
void takeUpExecutable(Context &context, GLuint program) {
  if (context.listMode != 0 || context.insideBeginEnd || context.hostProgramIsOurs)
    return;
  GLint current = 0;
  context.host->GetIntegerv(GL_CURRENT_PROGRAM, &current);
  if (GLuint(current) != program || program == 0)
    return;
  const HostErrorScope scope(*context.host,
                             context.errors.pending); // if the link failed, nothing changes
  context.host->UseProgram(program);
}

} // namespace

namespace handlers {

void LinkProgram(Context &context, GLuint program) {
  program = guardName(context, program);
  // Before the link, which may raise an error that is the application's.
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
  if (program != 0)
    context.group->linkedStages.set(program, stageOf(type));
  return program;
}

void BindProgramPipeline(Context &context, GLuint pipeline) {
  if (context.hostProgramIsOurs && !context.listMode)
    releaseHostState(context);
  context.host->BindProgramPipeline(guardedPipeline(context, pipeline));
  context.hostSide.stagePipeline->lookAgain(context); // in case a list is being compiled
  context.application.pipelinesUsed = true;
  invalidateProgram(context);
}

void UseProgramStages(Context &context, GLuint pipeline, GLbitfield stages, GLuint program) {
  context.host->UseProgramStages(guardedPipeline(context, pipeline), stages,
                                 guardName(context, program));
  invalidateProgram(context);
}

void DeleteProgramPipelines(Context &context, GLsizei count, const GLuint *pipelines) {
  // The host ignores names that it does not know.
  std::vector<GLuint> names(pipelines, pipelines + (pipelines ? std::max(count, 0) : 0));
  for (GLuint &name : names)
    name = guardedPipeline(context, name);
  context.host->DeleteProgramPipelines(count, pipelines ? names.data() : nullptr);
  invalidateProgram(context); // the bound pipeline may be deleted
}

void UseProgram(Context &context, GLuint program) {
  if (context.insideBeginEnd)
    return context.host->UseProgram(program); // the host raises the error
  if (context.listMode) {
    if (context.group->programApiUsed.load(std::memory_order_relaxed))
      return listCompiler(context).record(context,
                                          {.kind = Command::Kind::UseProgram, .name = program});
    context.group->hostListsChangeProgram.store(true, std::memory_order_relaxed);
    return context.host->UseProgram(program);
  }
  useProgram(context, program);
}

void PushAttrib(Context &context, GLbitfield mask) {
  if (context.insideBeginEnd)
    return context.host->PushAttrib(mask);
  if (!context.listMode)
    return pushAttrib(context, mask);
  listCompiler(context).notePush(mask);
  if (context.listMode == GL_COMPILE_AND_EXECUTE)
    pushEnables(context, mask);
  context.host->PushAttrib(mask);
}

void PopAttrib(Context &context) {
  if (context.insideBeginEnd)
    return context.host->PopAttrib();
  if (!context.listMode)
    return popAttrib(context);
  if (listCompiler(context).notePop())
    return listCompiler(context).record(context, {.kind = Command::Kind::PopAttrib});
  context.host->PopAttrib();
  if (context.listMode == GL_COMPILE_AND_EXECUTE)
    popEnables(context);
  noteFixedFunctionCommand(context);
}

} // namespace handlers
} // namespace arbiter::state
