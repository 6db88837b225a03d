// The commands of ATI_fragment_shader (3.8.11). Lists record Bind and SetFragmentShaderConstant;
// the others are executed at once (5.4).
#include <algorithm>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/lists/list_compiler.h"
#include "state/programs/ati_recorder.h"
#include "state/programs/fragment_shaders.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_load.h"
#include "state/programs/variants/drop_variants.h"
#include "state/share/share_group.h"
#include "state/statistics/statistics.h"

namespace arbiter::state {

namespace {

using fp::ati::SetupKind;
using RawOperation = AtiRecorder::RawOperation;

ProgramTarget &shaderRow(Context &context) { return context.row(Target::AtiApi); }

/// True outside a Begin/EndFragmentShader pair. Raises an error inside.
bool outsidePair(Context &context, const char *command) {
  if (!outsideBeginEnd(context, command))
    return false;
  if (!context.atiRecorder)
    return true;
  raise(context, GL_INVALID_OPERATION, command);
  return false;
}

/// Returns the recorder of the open pair. Raises an error and returns null outside of one.
AtiRecorder *insidePair(Context &context, const char *command) {
  if (!outsideBeginEnd(context, command))
    return nullptr;
  if (!context.atiRecorder)
    raise(context, GL_INVALID_OPERATION, command);
  return context.atiRecorder.get();
}

void judge(Context &context, const AtiRecorder::Verdict &verdict) {
  if (verdict.error != GL_NO_ERROR)
    raise(context, verdict.error, verdict.why);
}

void setup(Context &context, SetupKind kind, const char *command, GLuint dst, GLuint source,
           GLenum swizzle) {
  if (AtiRecorder *const recorder = insidePair(context, command))
    judge(context, recorder->setup(kind, dst, source, swizzle));
}

void operation(Context &context, const RawOperation &raw) {
  if (AtiRecorder *const recorder =
          insidePair(context, raw.alpha ? "AlphaFragmentOp outside Begin/EndFragmentShader"
                                        : "ColorFragmentOp outside Begin/EndFragmentShader"))
    judge(context, recorder->operation(raw));
}

/// Replaces the bound shader's program; null makes it undefined.
void replaceShader(Context &context, std::shared_ptr<const CompiledProgram> compiled) {
  ProgramTarget &row = shaderRow(context);
  const auto old = context.group->compiledOf(*row.bound);
  context.group->setCompiled(*row.bound, std::move(compiled));
  invalidateProgram(context);
  if (old)
    dropVariants(context, *old);
}

} // namespace

namespace handlers {

GLuint GenFragmentShadersATI(Context &context, GLuint range) {
  if (!outsidePair(context, "GenFragmentShaders between Begin- and EndFragmentShader"))
    return 0;
  if (range == 0) {
    raise(context, GL_INVALID_VALUE, "GenFragmentShaders: the range is 0");
    return 0;
  }
  return context.group->fragmentShaders.generate(range);
}

void BindFragmentShaderATI(Context &context, GLuint id) {
  if (!outsideBeginEnd(context, "BindFragmentShader between Begin and End"))
    return;
  noteProgramApiUse(context);
  if (context.listMode)
    return listCompiler(context).record(
        context,
        {.kind = Command::Kind::BindProgram, .target = infoOf(Target::AtiApi).name, .name = id});
  bindFragmentShader(context, id);
}

void DeleteFragmentShaderATI(Context &context, GLuint id) {
  if (!outsidePair(context, "DeleteFragmentShader between Begin- and EndFragmentShader") || id == 0)
    return;
  const std::shared_ptr<ProgramObject> object = context.group->fragmentShaders.remove(id);
  if (!object)
    return;
  ProgramTarget &row = shaderRow(context);
  if (row.bound == object) {
    row.bound = context.group->defaultProgram(Target::AtiApi);
    invalidateProgram(context);
  }
  // Other contexts may have it bound. Their linked programs are dropped when they are swept.
  if (const auto compiled = context.group->compiledOf(*object))
    dropVariants(context, *compiled);
}

void BeginFragmentShaderATI(Context &context) {
  if (!outsidePair(context, "BeginFragmentShader between Begin- and EndFragmentShader"))
    return;
  const fp::Limits &limits = shaderRow(context).limits;
  context.atiRecorder =
      std::make_unique<AtiRecorder>(limits.textureImageUnits, limits.textureCoords);
}

void EndFragmentShaderATI(Context &context) {
  if (!insidePair(context, "EndFragmentShader without BeginFragmentShader"))
    return;
  // An error closes the pair too, and so does lack of memory.
  const std::unique_ptr<AtiRecorder> recorder = std::move(context.atiRecorder);
  const AtiRecorder::Verdict verdict = recorder->end();
  const bool valid = verdict.error == GL_NO_ERROR;
  auto compiled = valid ? compileFragmentShader(context, recorder->shader()) : nullptr;
  noteFragmentShader(context, *shaderRow(context).bound, compiled.get(), verdict.why);
  if (compiled)
    noteShaderText(context, *compiled);
  replaceShader(context, std::move(compiled));
  judge(context, verdict);
}

void PassTexCoordATI(Context &context, GLuint dst, GLuint coord, GLenum swizzle) {
  setup(context, SetupKind::PassTexCoord, "PassTexCoord outside Begin/EndFragmentShader", dst,
        coord, swizzle);
}

void SampleMapATI(Context &context, GLuint dst, GLuint interp, GLenum swizzle) {
  setup(context, SetupKind::SampleMap, "SampleMap outside Begin/EndFragmentShader", dst, interp,
        swizzle);
}

void ColorFragmentOp1ATI(Context &context, GLenum op, GLuint dst, GLuint dstMask, GLuint dstMod,
                         GLuint arg1, GLuint arg1Rep, GLuint arg1Mod) {
  operation(context, {false, 1, op, dst, dstMask, dstMod, {{{arg1, arg1Rep, arg1Mod}}}});
}

void ColorFragmentOp2ATI(Context &context, GLenum op, GLuint dst, GLuint dstMask, GLuint dstMod,
                         GLuint arg1, GLuint arg1Rep, GLuint arg1Mod, GLuint arg2, GLuint arg2Rep,
                         GLuint arg2Mod) {
  operation(
      context,
      {false, 2, op, dst, dstMask, dstMod, {{{arg1, arg1Rep, arg1Mod}, {arg2, arg2Rep, arg2Mod}}}});
}

void ColorFragmentOp3ATI(Context &context, GLenum op, GLuint dst, GLuint dstMask, GLuint dstMod,
                         GLuint arg1, GLuint arg1Rep, GLuint arg1Mod, GLuint arg2, GLuint arg2Rep,
                         GLuint arg2Mod, GLuint arg3, GLuint arg3Rep, GLuint arg3Mod) {
  operation(context,
            {false,
             3,
             op,
             dst,
             dstMask,
             dstMod,
             {{{arg1, arg1Rep, arg1Mod}, {arg2, arg2Rep, arg2Mod}, {arg3, arg3Rep, arg3Mod}}}});
}

void AlphaFragmentOp1ATI(Context &context, GLenum op, GLuint dst, GLuint dstMod, GLuint arg1,
                         GLuint arg1Rep, GLuint arg1Mod) {
  operation(context, {true, 1, op, dst, GL_NONE, dstMod, {{{arg1, arg1Rep, arg1Mod}}}});
}

void AlphaFragmentOp2ATI(Context &context, GLenum op, GLuint dst, GLuint dstMod, GLuint arg1,
                         GLuint arg1Rep, GLuint arg1Mod, GLuint arg2, GLuint arg2Rep,
                         GLuint arg2Mod) {
  operation(
      context,
      {true, 2, op, dst, GL_NONE, dstMod, {{{arg1, arg1Rep, arg1Mod}, {arg2, arg2Rep, arg2Mod}}}});
}

void AlphaFragmentOp3ATI(Context &context, GLenum op, GLuint dst, GLuint dstMod, GLuint arg1,
                         GLuint arg1Rep, GLuint arg1Mod, GLuint arg2, GLuint arg2Rep,
                         GLuint arg2Mod, GLuint arg3, GLuint arg3Rep, GLuint arg3Mod) {
  operation(context,
            {true,
             3,
             op,
             dst,
             GL_NONE,
             dstMod,
             {{{arg1, arg1Rep, arg1Mod}, {arg2, arg2Rep, arg2Mod}, {arg3, arg3Rep, arg3Mod}}}});
}

void SetFragmentShaderConstantATI(Context &context, GLuint dst, const GLfloat *value) {
  if (!outsideBeginEnd(context, "SetFragmentShaderConstant between Begin and End"))
    return;
  const int constant = atiConstant(dst);
  if (constant < 0)
    return raise(context, GL_INVALID_ENUM, "SetFragmentShaderConstant: dst is no constant");
  if (!value)
    return;
  const Vec4 values = {value[0], value[1], value[2], value[3]};
  if (!context.listMode)
    return setFragmentShaderConstant(context, constant, values);
  noteProgramApiUse(context);
  Command command{
      .kind = Command::Kind::Env, .target = infoOf(Target::AtiApi).name, .name = GLuint(constant)};
  command.count = 1;
  command.values.assign(1, values);
  listCompiler(context).record(context, std::move(command));
}

} // namespace handlers
} // namespace arbiter::state
