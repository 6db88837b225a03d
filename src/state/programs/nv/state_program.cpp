// Implements ExecuteProgramNV (NV_vertex_program 2.14.4): the interpreter runs a state program
// once.
#include <algorithm>

#include "fp_compiler/ir/evaluate.h"
#include "state/core/errors.h"
#include "state/programs/nv/matrix_tracking.h"
#include "state/programs/nv/nv_programs.h"
#include "state/programs/program_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Returns the program if it may be executed now, or null after an error.
std::shared_ptr<const CompiledProgram> validStateProgram(ProgramContext &context, GLuint id) {
  const std::shared_ptr<ProgramObject> object = existingProgram(context, id);
  if (!object || object->target != Target::VertexState) {
    raise(context, GL_INVALID_OPERATION, "ExecuteProgram: the id is no state program's");
    return nullptr;
  }
  std::shared_ptr<const CompiledProgram> compiled = context.group->compiledOf(*object);
  const ProgramTarget &row = context.row(Target::Vertex);
  const auto &written = compiled->native.rowsWritten;
  if (std::none_of(written.begin(), written.end(), [&](auto index) { return row.follows(index); }))
    return compiled;
  raise(context, GL_INVALID_OPERATION,
        "ExecuteProgram: the program writes a parameter that follows a matrix");
  return nullptr;
}

fp::ir::Evaluation run(const ProgramTarget &row, const fp::ir::Program &program,
                       const Vec4 &input) {
  // The program may read v[0] only.
  const std::vector<Vec4> attributes(program.attributes.size(), input);
  fp::ir::Inputs inputs;
  inputs.attributes = attributes;
  inputs.parameter = [&](const fp::ir::Parameter &parameter) {
    if (parameter.kind == fp::ir::ParameterKind::Constant)
      return parameter.constant;
    return parameter.index < row.env.size() ? row.env[parameter.index] : Vec4{};
  };
  return fp::ir::evaluate(program, inputs);
}

} // namespace

void executeStateProgram(ProgramContext &context, GLenum target, GLuint id, const Vec4 &input) {
  if (target != infoOf(Target::VertexState).name)
    return raise(context, GL_INVALID_ENUM, "ExecuteProgram: target");
  const auto compiled = validStateProgram(context, id);
  if (!compiled)
    return;
  refreshTrackedMatrices(context); // the program may read them
  ProgramTarget &row = context.row(Target::Vertex);
  const fp::ir::Program &program = *compiled->program;
  const fp::ir::Evaluation result = run(row, program, input);
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    if (program.outputs[i].kind == fp::ir::OutputKind::EnvParameter &&
        program.outputs[i].index < row.env.size())
      row.env[program.outputs[i].index] = result.outputs[i];
  ++row.envVersion;
  context.attention |= row.parameterBits;
}

} // namespace arbiter::state
