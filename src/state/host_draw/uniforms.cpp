// Implements uploadParameters(), which sends the changed parameters of the effective programs.
#include "state/host_draw/uniforms.h"
#include "host/host_table.h"
#include "state/core/host_state.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/objects/linked_program.h"
#include "state/programs/program_edits.h"
#include "util/numbers/same_bits.h"

namespace arbiter::state {

Vec4 currentValue(DrawContext &context, const ProgramTarget &row,
                  const fp::ir::Parameter &parameter) {
  if (anyHeld()) [[unlikely]]
    if (const bool env = parameter.kind == fp::ir::ParameterKind::Env;
        env || parameter.kind == fp::ir::ParameterKind::Local)
      if (const auto held = findHeld(context, row, env, parameter.index))
        return *held;
  if (parameter.kind != fp::ir::ParameterKind::State)
    return ownValue(row, parameter);
  Vec4 value{};
  fetchState(context, parameter.state, value.data());
  return value;
}

namespace {

/// \param program the program of the stage, if it is linked alone; 0: the current program
void uploadStage(DrawContext &context, LinkedProgramStage &stage, GLuint program) {
  const ProgramTarget &row = context.row(stage.compiled->target);
  const auto &uniforms = stage.compiled->glsl.uniforms;
  const bool held = anyHeld();
  std::size_t begin = 0; // the current run of changed values
  std::size_t end = 0;
  const auto flush = [&] {
    const GLfloat *const values = begin != end ? stage.uploaded[begin].data() : nullptr;
    if (values && program != 0)
      context.host->ProgramUniform4fv(program, stage.locations[begin], GLsizei(end - begin),
                                      values);
    else if (values)
      context.host->Uniform4fv(stage.locations[begin], GLsizei(end - begin), values);
    begin = end = 0;
  };
  for (std::size_t i = 0; i < uniforms.size(); ++i) {
    if (stage.locations[i] < 0)
      continue;
    const fp::ir::Parameter &parameter = uniforms[i].parameter;
    const Vec4 value = held || parameter.kind == fp::ir::ParameterKind::State
                           ? currentValue(context, row, parameter)
                           : ownValue(row, parameter);
    if (sameBits(value, stage.uploaded[i]))
      continue;
    stage.uploaded[i] = value;
    const bool joins =
        begin != end && end == i && stage.locations[i] == stage.locations[begin] + GLint(i - begin);
    if (!joins) {
      flush();
      begin = i;
    }
    end = i + 1;
  }
  flush();
}

} // namespace

void uploadParameters(DrawContext &context, LinkedProgram &linkedProgram, std::uint32_t attention) {
  const bool apart = linkedProgram.vertexProgram != 0;
  const auto upload = [&](LinkedProgramStage &stage, GLuint program, std::uint32_t bits) {
    if (stage.readsState)
      bits |= attention::kState;
    if ((attention & bits) != 0 && !stage.locations.empty())
      uploadStage(context, stage, apart ? program : 0);
  };
  std::uint32_t assembly = 0; // attention bits of the stages that are assembly
  if (linkedProgram.vertexAssembly)
    assembly |= attention::kVertexParameters;
  else
    upload(*linkedProgram.stages()[0], linkedProgram.vertexProgram, attention::kVertexParameters);
  if (linkedProgram.fragmentAssembly)
    assembly |= attention::kFragmentParameters;
  else
    upload(*linkedProgram.stages()[1], linkedProgram.hostProgram, attention::kFragmentParameters);
  // A capture of assembly programs also looks at rows of state.
  if ((attention & attention::kState) != 0 && linkedProgram.readsState)
    attention |= assembly;
  if ((attention & assembly) != 0)
    context.hostSide.assembly->uploadParameters(context, attention);
}

} // namespace arbiter::state
