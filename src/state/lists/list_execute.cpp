// Executes the layer's commands in a list, when it is called.
#include "state/lists/list_compiler.h"

#include <array>
#include <cstring>

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/era/era_state.h"
#include "state/era/texture_range.h"
#include "state/host_draw/evaluators/evaluation.h"
#include "state/host_draw/use_program.h"
#include "state/lists/conditional_commands.h"
#include "state/lists/mesh_commands.h"
#include "state/lists/state_commands.h"
#include "state/pixel_commands/copy_texture.h"
#include "state/pixel_commands/imaging_commands.h"
#include "state/programs/combiners/combiner_commands.h"
#include "state/programs/fragment_shaders.h"
#include "state/programs/nv/matrix_tracking.h"
#include "state/programs/nv/nv_programs.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/parameters.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_load.h"
#include "state/programs/texture_shaders/component_image.h"
#include "state/programs/texture_shaders/texture_shader_commands.h"
#include "state/programs/variants/point_sprites.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/raster_draw/context_state.h"

namespace arbiter::state {

namespace {

/// Executes a command of ATI_fragment_shader.
void executeFragmentShader(RasterContext &context, const Command &command) {
  if (command.kind == Command::Kind::BindProgram)
    bindFragmentShader(context, command.name);
  else
    setFragmentShaderConstant(context, int(command.name), command.values.front());
}

/// Executes a command of EXT_vertex_shader.
void executeVertexShader(RasterContext &context, const Command &command) {
  if (command.kind == Command::Kind::BindProgram)
    bindVertexShader(context, command.name);
  else
    setInvariant(context, command.name, command.values);
}

/// Executes the command's bind and those that were joined to it.
void bindPrograms(RasterContext &context, ProgramTarget &row, const Command &command) {
  bindProgram(context, row, command.name);
  for (std::size_t at = 0; at < command.bytes.size(); at += sizeof command.name) {
    GLuint name = 0;
    std::memcpy(&name, command.bytes.data() + at, sizeof name);
    bindProgram(context, row, name);
  }
}

/// Executes a command of the program API. Its target was one of the layer's when it was recorded.
void executeProgram(RasterContext &context, ProgramTarget &row, const Command &command) {
  const bool enables =
      command.kind == Command::Kind::Enable || command.kind == Command::Kind::Disable;
  if (row.target == Target::AtiApi && !enables)
    return executeFragmentShader(context, command);
  if (row.target == Target::VertexShader && !enables)
    return executeVertexShader(context, command);
  const bool named =
      command.kind == Command::Kind::NamedString || command.kind == Command::Kind::NamedLocal;
  const std::shared_ptr<ProgramObject> object =
      named ? namedProgram(context, row, command.object) : row.bound;
  if (!object)
    return;
  switch (command.kind) {
  case Command::Kind::ProgramString:
  case Command::Kind::NamedString:
    return loadProgram(context, *object, command.format, command.count, command.bytes.data());
  case Command::Kind::BindProgram:
    return bindPrograms(context, row, command);
  case Command::Kind::Env:
    return setEnv(context, row, command.name, command.count, command.values.data());
  case Command::Kind::Local:
  case Command::Kind::NamedLocal:
    return setLocal(context, *object, command.name, command.count, command.values.data());
  case Command::Kind::Enable:
  case Command::Kind::Disable:
    return setEnabled(context, row, command.kind == Command::Kind::Enable);
  default:
    return;
  }
}

MapDefinition mapOf(const Command &command) {
  MapDefinition definition{.target = command.target, .error = command.format};
  if (command.values.empty())
    return definition;
  definition.map.order = {GLint(command.name), GLint(command.object)};
  definition.map.domain = command.values.front();
  definition.map.points.assign(command.values.begin() + 1, command.values.end());
  return definition;
}

EvaluatorPoint pointOf(const Command &command) {
  EvaluatorPoint point;
  std::memcpy(&point, command.bytes.data(), sizeof point);
  return point;
}

void evalMesh(RasterContext &context, const Command &command) {
  std::array<GLint, 4> range{};
  std::memcpy(range.data(), command.bytes.data(), sizeof range);
  issueEvalMesh(context, {command.name, command.target, range[0], range[1], range[2], range[3]});
}

/// Executes a command of NVIDIA's program API. It was available when recorded, but contexts of a
/// share group may run on different host contexts.
void executeNvCommand(RasterContext &context, const Command &command) {
  if (!context.nv)
    return raise(context, GL_INVALID_OPERATION, "a list's command of NV_vertex_program");
  switch (command.kind) {
  case Command::Kind::LoadNv:
    return loadNvProgram(context, command.target, command.name, command.count,
                         command.bytes.data());
  case Command::Kind::BindNv:
    return bindNvProgram(context, command.target, command.name);
  case Command::Kind::ExecuteNv:
    return executeStateProgram(context, command.target, command.name, command.values.front());
  case Command::Kind::TrackMatrix:
    return trackMatrix(context, command.target, command.name, command.object, command.format);
  case Command::Kind::ParameterNv:
    return setNvParameters(context, command.target, command.name, command.count,
                           command.values.data());
  case Command::Kind::NamedParameterNv:
    return setNamedParameter(context, command.name, command.bytes,
                             host::ParameterValues(command.values.front().data()));
  case Command::Kind::RequestResident:
    if (command.count < 0)
      raise(context, GL_INVALID_VALUE, "RequestResidentPrograms: n is negative");
    return;
  case Command::Kind::DefineMap:
    return defineMap(context, mapOf(command));
  case Command::Kind::EvalMesh:
    return evalMesh(context, command);
  default:
    return;
  }
}

} // namespace

void execute(RasterContext &context, const Command &command) {
  if (command.kind == Command::Kind::PrepareEvaluation)
    return prepareEvaluation(context);
  if (command.kind == Command::Kind::EvalPoint)
    return evaluatePoint(context, pointOf(command));
  if (command.kind == Command::Kind::State)
    return executeStateCommands(context, command.bytes);
  const bool nested =
      command.kind == Command::Kind::CallList || command.kind == Command::Kind::CallLists;
  if (!nested && !outsideBeginEnd(context, "a command of a list between Begin and End"))
    return;
  switch (command.kind) {
  case Command::Kind::ProgramString:
  case Command::Kind::BindProgram:
  case Command::Kind::Env:
  case Command::Kind::Local:
  case Command::Kind::NamedString:
  case Command::Kind::NamedLocal:
  case Command::Kind::Enable:
  case Command::Kind::Disable:
    if (context.nv && isEvaluatorMap(command.target))
      enableMap(context, command.target, command.kind == Command::Kind::Enable);
    else if (ProgramTarget *const row = enableRowOf(context, command.target))
      executeProgram(context, *row, command);
    return;
  case Command::Kind::UseProgram:
    return useProgram(context, command.name);
  case Command::Kind::AttribPushed:
    return pushEnables(context, command.name);
  case Command::Kind::PopAttrib:
    return popAttrib(context);
  case Command::Kind::CallList:
    return callList(context, command.name);
  case Command::Kind::CallLists:
    return callLists(context, command.count, command.target, command.bytes.data());
  case Command::Kind::BeginConditional:
    return issueBeginConditional(context, command.name, command.target);
  case Command::Kind::EndConditional:
    return issueEndConditional(context);
  case Command::Kind::SetFence:
    return setFence(context, FenceOf(command.target), command.name, command.format);
  case Command::Kind::FinishFence:
    return finishFence(context, FenceOf(command.target), command.name);
  case Command::Kind::Hint:
    return setEraHint(context, command.target, command.name);
  case Command::Kind::SpriteMode:
    if (context.era && context.era->offered.pointSprite)
      setSpriteMode(context, command.target);
    return;
  case Command::Kind::PrimitiveMode:
    return notePrimitiveMode(context, command.target);
  case Command::Kind::CoordReplace:
    releaseSprites(context);
    return context.host->TexEnvi(GL_POINT_SPRITE, command.target, command.count);
  case Command::Kind::Imaging:
    return executeImaging(context, command);
  case Command::Kind::TextureRange:
    return executeTextureRange(context, command);
  case Command::Kind::Combiners:
    return executeCombinerCommands(context, command.bytes);
  case Command::Kind::TextureShaders:
    return executeTextureShaderCommands(context, command.bytes);
  case Command::Kind::ComponentImage:
    if (context.software)
      context.software->residency.textureRedefined(componentImageOf(command.bytes).target);
    return executeComponentImage(context, command.bytes);
  case Command::Kind::CopyTexture:
    return copyTexture(context, copyOf(command));
  default:
    return executeNvCommand(context, command);
  }
}

} // namespace arbiter::state
