#include "state/programs/texture_shaders/texture_shader_commands.h"

#include <cstring>
#include <type_traits>

#include "enumerants/texture_shaders.h"
#include "fp_compiler/texture_shader/operations.h"
#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/programs/program_context.h"
#include "state/programs/texture_shaders/component_image.h"
#include "state/programs/texture_shaders/texture_shader_state.h"

namespace arbiter::state {

namespace {

using fp::texture_shader::Operation;
using fp::texture_shader::Row;

static_assert(std::is_trivially_copyable_v<TextureShaderCommand>);

/// An error of a command.
struct Wrong {
  GLenum error = GL_NO_ERROR;
  const char *why = "";
};

/// Returns an enumerant that was passed as a float.
GLenum nameIn(GLfloat value) { return value >= 0.0f && value < 16777216.0f ? GLenum(value) : ~0u; }

Wrong operation(ProgramContext &context, TextureShaderState &shaders, int unit, GLenum name) {
  const auto wanted = enumerants::shaderOperation(name, shaders.extensions());
  if (!wanted)
    return {GL_INVALID_ENUM, "TexEnv: SHADER_OPERATION_NV"};
  const bool notLast =
      *wanted == Operation::DotProduct || *wanted == Operation::DotProductDiffuseCubeMap;
  if (unit < fp::texture_shader::infoOf(*wanted).firstUnit ||
      (notLast && unit == shaders.units() - 1))
    return {GL_INVALID_OPERATION, "TexEnv: the unit cannot have this SHADER_OPERATION_NV"};
  shaders.set(
      context,
      [&](auto &settings) -> auto & { return settings.stages[std::size_t(unit)].operation; },
      *wanted);
  return {};
}

Wrong previous(ProgramContext &context, TextureShaderState &shaders, int unit, GLenum name) {
  const GLenum input = name - GL_TEXTURE0;
  if (input >= GLenum(fp::texture_shader::kUnits))
    return {GL_INVALID_ENUM, "TexEnv: PREVIOUS_TEXTURE_INPUT_NV"};
  if (int(input) >= unit)
    return {GL_INVALID_OPERATION, "TexEnv: PREVIOUS_TEXTURE_INPUT_NV is of an earlier unit"};
  shaders.set(
      context,
      [&](auto &settings) -> auto & { return settings.stages[std::size_t(unit)].previous; },
      std::uint8_t(input));
  return {};
}

Wrong cullModes(ProgramContext &context, TextureShaderState &shaders, int unit,
                const Vec4 &values) {
  std::uint8_t less = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const GLenum name = nameIn(values[i]);
    if (name != GL_LESS && name != GL_GEQUAL)
      return {GL_INVALID_ENUM, "TexEnv: CULL_MODES_NV are LESS or GEQUAL"};
    less |= std::uint8_t((name == GL_LESS ? 1u : 0u) << i);
  }
  shaders.set(
      context,
      [&](auto &settings) -> auto & { return settings.stages[std::size_t(unit)].cullLess; }, less);
  return {};
}

Wrong mapping(ProgramContext &context, TextureShaderState &shaders, int unit, GLenum name) {
  const auto wanted = enumerants::dotProductMapping(name, shaders.extensions());
  if (!wanted)
    return {GL_INVALID_ENUM, "TexEnv: RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV"};
  shaders.set(
      context, [&](auto &settings) -> auto & { return settings.stages[std::size_t(unit)].mapping; },
      *wanted);
  return {};
}

Wrong environment(ProgramContext &context, TextureShaderState &shaders,
                  const TextureShaderCommand &command) {
  const int count = textureShaderValues(command.pname);
  if (count == 0 || (command.scalar && count != 1))
    return {GL_INVALID_ENUM, "TexEnv: pname of TEXTURE_SHADER_NV"};
  const GLuint unit = activeUnit(context);
  if (unit >= GLuint(shaders.units()))
    return {GL_INVALID_OPERATION, "TexEnv: the active unit has no texture environment"};
  const int at = int(unit);
  const auto &rows = shaders.now().rows[unit];
  switch (command.pname) {
  case GL_SHADER_OPERATION_NV:
    return operation(context, shaders, at, nameIn(command.values[0]));
  case GL_PREVIOUS_TEXTURE_INPUT_NV:
    return previous(context, shaders, at, nameIn(command.values[0]));
  case GL_CULL_MODES_NV:
    return cullModes(context, shaders, at, command.values);
  case GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV:
    return mapping(context, shaders, at, nameIn(command.values[0]));
  case GL_OFFSET_TEXTURE_MATRIX_NV:
    shaders.setRow(context, at, Row::Matrix, command.values);
    return {};
  case GL_CONST_EYE_NV:
    shaders.setRow(context, at, Row::Eye,
                   {command.values[0], command.values[1], command.values[2], 0});
    return {};
  default: {
    Vec4 both = rows[std::size_t(Row::ScaleBias)];
    both[command.pname == GL_OFFSET_TEXTURE_SCALE_NV ? 0 : 1] = command.values[0];
    shaders.setRow(context, at, Row::ScaleBias, both);
    return {};
  }
  }
}

void mode(ProgramContext &context, TextureShaderState &shaders, bool none) {
  const GLuint unit = activeUnit(context);
  if (unit >= GLuint(shaders.units())) {
    if (none)
      raise(context, GL_INVALID_OPERATION, "TexEnv: the active unit has no texture environment");
    return;
  }
  const std::uint8_t before = shaders.now().environmentNone;
  const auto after = std::uint8_t(none ? before | 1u << unit : before & ~(1u << unit));
  shaders.set(
      context, [](auto &settings) -> auto & { return settings.environmentNone; }, after);
}

// --- ATI_envmap_bumpmap ---

void bumpMode(ProgramContext &context, TextureShaderState &shaders, bool bumps) {
  const GLuint unit = activeUnit(context);
  if (unit >= GLuint(shaders.units())) {
    if (bumps)
      raise(context, GL_INVALID_VALUE, "TexEnv: the active unit cannot have BUMP_ENVMAP_ATI");
    return;
  }
  const std::uint8_t before = shaders.now().bumps;
  const auto after = std::uint8_t(bumps ? before | 1u << unit : before & ~(1u << unit));
  shaders.set(
      context, [](auto &settings) -> auto & { return settings.bumps; }, after);
}

void bumpTarget(ProgramContext &context, TextureShaderState &shaders, GLenum name) {
  const GLenum target = name - GL_TEXTURE0;
  if (target >= 32)
    return raise(context, GL_INVALID_ENUM, "TexEnv: BUMP_TARGET_ATI");
  const GLuint unit = activeUnit(context);
  if (target >= GLenum(shaders.units()) || unit >= GLuint(shaders.units()))
    return raise(context, GL_INVALID_VALUE, "TexEnv: BUMP_TARGET_ATI: there is no such unit");
  shaders.set(
      context, [&](auto &settings) -> auto & { return settings.bumpTargets[unit]; },
      std::uint8_t(target));
}

void bumpMatrix(ProgramContext &context, TextureShaderState &shaders, const Vec4 &matrix) {
  const GLuint unit = activeUnit(context);
  if (unit >= GLuint(shaders.units()))
    return raise(context, GL_INVALID_OPERATION, "TexBumpParameter: the active unit has no texture");
  shaders.setRow(context, int(unit), Row::Bump, matrix);
}

} // namespace

GLuint activeUnit(const ProgramContext &context) {
  GLint active = GL_TEXTURE0;
  context.host->GetIntegerv(GL_ACTIVE_TEXTURE, &active);
  return GLuint(active) - GL_TEXTURE0;
}

int textureShaderValues(GLenum pname) {
  switch (pname) {
  case GL_SHADER_OPERATION_NV:
  case GL_PREVIOUS_TEXTURE_INPUT_NV:
  case GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV:
  case GL_OFFSET_TEXTURE_SCALE_NV:
  case GL_OFFSET_TEXTURE_BIAS_NV:
    return 1;
  case GL_CULL_MODES_NV:
  case GL_OFFSET_TEXTURE_MATRIX_NV:
    return 4;
  case GL_CONST_EYE_NV:
    return 3;
  default:
    return 0;
  }
}

int componentTransfer(GLenum pname) {
  const GLenum at = pname - GL_HI_SCALE_NV;
  return at < 12 ? int(at) : -1;
}

void executeTextureShaderCommand(ProgramContext &context, const TextureShaderCommand &command) {
  TextureShaderState &shaders = *context.textureShaders;
  switch (command.kind) {
  case TextureShaderCommand::Kind::Environment:
    if (const Wrong wrong = environment(context, shaders, command); wrong.error != GL_NO_ERROR)
      raise(context, wrong.error, wrong.why);
    return;
  case TextureShaderCommand::Kind::Mode:
    return mode(context, shaders, command.values[0] != 0.0f);
  case TextureShaderCommand::Kind::BumpMode:
    return bumpMode(context, shaders, command.values[0] != 0.0f);
  case TextureShaderCommand::Kind::BumpTarget:
    return bumpTarget(context, shaders, nameIn(command.values[0]));
  case TextureShaderCommand::Kind::BumpMatrix:
    return bumpMatrix(context, shaders, command.values);
  case TextureShaderCommand::Kind::Format:
    return noteImageFormat(context, GLenum(command.values[0]), GLint(command.values[1]),
                           command.pname);
  case TextureShaderCommand::Kind::Transfer: {
    const auto at = std::size_t(componentTransfer(command.pname));
    (at < 6 ? shaders.transfers.scales[at] : shaders.transfers.biases[at - 6]) = command.values[0];
    return;
  }
  }
}

std::string bytesOf(const TextureShaderCommand &command) {
  return {reinterpret_cast<const char *>(&command), sizeof command};
}

void executeTextureShaderCommands(ProgramContext &context, const std::string &bytes) {
  if (!mayKeepTextures(context))
    return raise(context, GL_INVALID_OPERATION, "a list's command of NV_texture_shader");
  keepTextures(context);
  for (std::size_t at = 0; at + sizeof(TextureShaderCommand) <= bytes.size();
       at += sizeof(TextureShaderCommand)) {
    TextureShaderCommand command;
    std::memcpy(&command, bytes.data() + at, sizeof command);
    executeTextureShaderCommand(context, command);
  }
}

} // namespace arbiter::state
