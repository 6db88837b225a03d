#include "state/host_draw/stages/stage_pipeline.h"

#include <utility>

#include "host/host_table.h"
#include "state/host_draw/draw_context.h"

namespace arbiter::state {

bool stagesStandApart(const DrawContext &context) {
  return context.caps.onProcessor && context.caps.pipelines;
}

bool StagePipeline::make(DrawContext &context) {
  if (m_name == 0)
    context.host->GenProgramPipelines(1, &m_name);
  return m_name != 0;
}

void StagePipeline::setStage(DrawContext &context, GLbitfield stage, GLuint &held, GLuint program) {
  if (std::exchange(held, program) != program)
    context.host->UseProgramStages(m_name, stage, program);
}

void StagePipeline::use(DrawContext &context, GLuint vertex, GLuint fragment) {
  setStage(context, GL_VERTEX_SHADER_BIT, m_vertex, vertex);
  setStage(context, GL_FRAGMENT_SHADER_BIT, m_fragment, fragment);
  context.host->UseProgram(0); // a current program would take precedence over the pipeline
  if (!std::exchange(m_isBound, true))
    context.host->BindProgramPipeline(m_name);
  m_current = 0;
}

void StagePipeline::useAlone(DrawContext &context, GLuint program) {
  release(context);
  if (context.hostProgramIsOurs && m_current == program)
    return;
  context.host->UseProgram(program);
  context.hostProgramIsOurs = true;
  m_current = program;
}

void StagePipeline::release(DrawContext &context) {
  if (std::exchange(m_isBound, false))
    context.host->BindProgramPipeline(0);
}

void StagePipeline::lookAgain(DrawContext &context) {
  if (!m_isBound)
    return;
  GLint bound = 0;
  context.host->GetIntegerv(GL_PROGRAM_PIPELINE_BINDING, &bound);
  m_isBound = GLuint(bound) == m_name;
}

void StagePipeline::forget(DrawContext &context, GLuint program) {
  if (program == 0)
    return;
  if (m_current == program)
    m_current = 0;
  // A later program may get the name, and the host keeps what a pipeline holds.
  if (m_vertex == program)
    setStage(context, GL_VERTEX_SHADER_BIT, m_vertex, 0);
  if (m_fragment == program)
    setStage(context, GL_FRAGMENT_SHADER_BIT, m_fragment, 0);
}

} // namespace arbiter::state
