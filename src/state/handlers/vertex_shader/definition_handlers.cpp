// The commands of EXT_vertex_shader that make, bind and define shaders. The specification does not
// say which ones lists hold. Here BindVertexShader is, and the others are executed at once, as a
// definition uses names that its commands return.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_bind.h"
#include "state/programs/variants/drop_variants.h"
#include "state/programs/vertex_shaders/define_shader.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

using Verdict = VertexShaderRecorder::Verdict;

/// True outside a Begin/EndVertexShader pair. Raises an error inside.
bool outsidePair(Context &context, const char *command) {
  if (!outsideBeginEnd(context, command))
    return false;
  if (!context.vertexShaders->recorder)
    return true;
  raise(context, GL_INVALID_OPERATION, command);
  return false;
}

/// Returns the recorder of the open pair. Raises an error and returns null outside of one.
VertexShaderRecorder *insidePair(Context &context, const char *command) {
  if (!outsideBeginEnd(context, command))
    return nullptr;
  if (!context.vertexShaders->recorder)
    raise(context, GL_INVALID_OPERATION, command);
  return context.vertexShaders->recorder.get();
}

void judge(Context &context, const Verdict &verdict) {
  if (verdict.error != GL_NO_ERROR)
    raise(context, verdict.error, verdict.why);
}

void operation(Context &context, GLenum op, GLuint result, int count,
               const std::array<GLuint, 3> &arguments) {
  if (VertexShaderRecorder *const recorder =
          insidePair(context, "ShaderOp outside Begin/EndVertexShader"))
    judge(context, recorder->operation(op, result, count, arguments));
}

} // namespace

namespace handlers {

GLuint GenVertexShadersEXT(Context &context, GLuint range) {
  if (!outsidePair(context, "GenVertexShaders between Begin- and EndVertexShader"))
    return 0;
  return context.group->vertexShaders.generate(range);
}

void BindVertexShaderEXT(Context &context, GLuint id) {
  if (!outsideBeginEnd(context, "BindVertexShader between Begin and End"))
    return;
  noteProgramApiUse(context);
  if (context.listMode)
    return listCompiler(context).record(context, {.kind = Command::Kind::BindProgram,
                                                  .target = infoOf(Target::VertexShader).name,
                                                  .name = id});
  bindVertexShader(context, id);
}

void DeleteVertexShaderEXT(Context &context, GLuint id) {
  if (!outsidePair(context, "DeleteVertexShader between Begin- and EndVertexShader") || id == 0)
    return;
  const std::shared_ptr<ProgramObject> object = context.group->vertexShaders.remove(id);
  if (!object)
    return;
  ProgramTarget &row = context.row(Target::VertexShader);
  if (row.bound == object) {
    row.bound = context.group->defaultProgram(Target::VertexShader);
    invalidateProgram(context);
  }
  // Other contexts may have it bound. Their linked programs are dropped when they are swept.
  if (const auto compiled = context.group->compiledOf(*object))
    dropVariants(context, *compiled);
}

void BeginVertexShaderEXT(Context &context) {
  if (!outsidePair(context, "BeginVertexShader between Begin- and EndVertexShader"))
    return;
  context.vertexShaders->recorder = std::make_unique<VertexShaderRecorder>(
      context.group->vertexSymbols, context.row(Target::VertexShader).limits.textureCoords);
}

void EndVertexShaderEXT(Context &context) {
  if (!insidePair(context, "EndVertexShader without BeginVertexShader"))
    return;
  noteProgramApiUse(context);
  // Lack of memory closes the pair too.
  const std::unique_ptr<VertexShaderRecorder> recorder = std::move(context.vertexShaders->recorder);
  defineVertexShader(context, recorder->end());
}

void ShaderOp1EXT(Context &context, GLenum op, GLuint res, GLuint arg1) {
  operation(context, op, res, 1, {arg1});
}

void ShaderOp2EXT(Context &context, GLenum op, GLuint res, GLuint arg1, GLuint arg2) {
  operation(context, op, res, 2, {arg1, arg2});
}

void ShaderOp3EXT(Context &context, GLenum op, GLuint res, GLuint arg1, GLuint arg2, GLuint arg3) {
  operation(context, op, res, 3, {arg1, arg2, arg3});
}

void SwizzleEXT(Context &context, GLuint res, GLuint in, GLenum outX, GLenum outY, GLenum outZ,
                GLenum outW) {
  if (VertexShaderRecorder *const recorder =
          insidePair(context, "Swizzle outside Begin/EndVertexShader"))
    judge(context, recorder->swizzle(res, in, {outX, outY, outZ, outW}));
}

void WriteMaskEXT(Context &context, GLuint res, GLuint in, GLenum outX, GLenum outY, GLenum outZ,
                  GLenum outW) {
  if (VertexShaderRecorder *const recorder =
          insidePair(context, "WriteMask outside Begin/EndVertexShader"))
    judge(context, recorder->writeMask(res, in, {outX, outY, outZ, outW}));
}

void InsertComponentEXT(Context &context, GLuint res, GLuint src, GLuint num) {
  if (VertexShaderRecorder *const recorder =
          insidePair(context, "InsertComponent outside Begin/EndVertexShader"))
    judge(context, recorder->insert(res, src, num));
}

void ExtractComponentEXT(Context &context, GLuint res, GLuint src, GLuint num) {
  if (VertexShaderRecorder *const recorder =
          insidePair(context, "ExtractComponent outside Begin/EndVertexShader"))
    judge(context, recorder->extract(res, src, num));
}

} // namespace handlers
} // namespace arbiter::state
