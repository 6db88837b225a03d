// TexEnv and GetTexEnv: the stages of NV_texture_shader, the environment of ATI_envmap_bumpmap, and
// environments that draws depend on.
#include <cmath>
#include <type_traits>

#include "enumerants/texture_shaders.h"
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/host_draw/fixed_function.h"
#include "state/host_draw/sprite_commands.h"
#include "state/host_draw/texturing/texture_shader_draw.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_bind.h"
#include "state/programs/texture_shaders/texture_shader_commands.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/programs/variants/point_sprites.h"

namespace arbiter::state {

namespace {

using fp::texture_shader::Row;
using fp::texture_shader::Stage;

void issue(Context &context, const TextureShaderCommand &command) {
  noteProgramApiUse(context);
  if (context.listMode)
    return listCompiler(context).record(
        context, {.kind = Command::Kind::TextureShaders, .bytes = bytesOf(command)});
  executeTextureShaderCommand(context, command);
}

/// Executes TexEnv of TEXTURE_SHADER_NV. For an unknown pname `params` may point to nothing.
template <typename T> void setShader(Context &context, GLenum pname, const T *params, bool scalar) {
  if (!outsideBeginEnd(context, "TexEnv of TEXTURE_SHADER_NV between Begin and End"))
    return;
  TextureShaderCommand command{
      .kind = TextureShaderCommand::Kind::Environment, .scalar = scalar, .pname = pname};
  const int count = params ? textureShaderValues(pname) : 0;
  for (int i = 0; i < (scalar ? count != 0 : count); ++i)
    command.values[std::size_t(i)] = GLfloat(params[i]);
  context.textureShaders->used = true;
  issue(context, command);
}

/// True for an environment mode of the host's. It refuses others, and the unit keeps its mode.
bool isHostMode(GLenum mode) {
  switch (mode) {
  case GL_MODULATE:
  case GL_REPLACE:
  case GL_DECAL:
  case GL_BLEND:
  case GL_ADD:
  case GL_COMBINE:
  case GL_COMBINE4_NV:
    return true;
  default:
    return false;
  }
}

/// Sets TEXTURE_ENV_MODE NONE, which the host lacks, and returns true. Other modes clear it.
template <typename T> bool setMode(Context &context, GLenum target, GLenum pname, const T *params) {
  if (target != GL_TEXTURE_ENV || pname != GL_TEXTURE_ENV_MODE || !params || context.insideBeginEnd)
    return false;
  const bool none = params[0] == T(GL_NONE);
  TextureShaderState &shaders = *context.textureShaders;
  // The effect of a list's earlier commands is only known when it is called.
  const bool mayBeNone = shaders.now().environmentNone != 0 || (context.listMode && shaders.used);
  if (none || (mayBeNone && params[0] > T(0) && isHostMode(GLenum(params[0])))) {
    shaders.used = shaders.used || none;
    issue(context, {.kind = TextureShaderCommand::Kind::Mode, .values = {none ? 1.0f : 0.0f}});
  }
  return none;
}

/// Notes a changed texture environment. Draws that depend on it look again, and a list that is
/// being compiled is cut. Costs one test if none do.
void noteEnvironmentCommand(Context &context) {
  if (context.listMode != 0 || followsTextures(context))
    noteFixedFunctionCommand(context);
}

/// True for a COMBINE_RGB function of the host's. It refuses others.
bool isHostFunction(GLenum function) {
  switch (function) {
  case GL_REPLACE:
  case GL_MODULATE:
  case GL_ADD:
  case GL_ADD_SIGNED:
  case GL_INTERPOLATE:
  case GL_SUBTRACT:
  case GL_DOT3_RGB:
  case GL_DOT3_RGBA:
  case GL_MODULATE_ADD_ATI:
  case GL_MODULATE_SIGNED_ADD_ATI:
  case GL_MODULATE_SUBTRACT_ATI:
    return true;
  default:
    return false;
  }
}

/// Sets a parameter of ATI_envmap_bumpmap that the host lacks. Returns false for other parameters.
template <typename T> bool setBump(Context &context, GLenum pname, const T *params) {
  using Kind = TextureShaderCommand::Kind;
  if ((pname != GL_BUMP_TARGET_ATI && pname != GL_COMBINE_RGB) || !params || context.insideBeginEnd)
    return false;
  const bool bumps = pname == GL_COMBINE_RGB && params[0] == T(GL_BUMP_ENVMAP_ATI);
  if (bumps || pname == GL_BUMP_TARGET_ATI) {
    keepTextures(context).used = true;
    issue(context, {.kind = bumps ? Kind::BumpMode : Kind::BumpTarget,
                    .values = {bumps ? 1.0f : GLfloat(params[0])}});
    return true;
  }
  const TextureShaderState *const shaders = context.textureShaders.get();
  const bool mayBump =
      shaders && (shaders->now().bumps != 0 || (context.listMode && shaders->used));
  if (mayBump && params[0] > T(0) && isHostFunction(GLenum(params[0])))
    issue(context, {.kind = Kind::BumpMode});
  return false;
}

template <typename T, typename Host>
void set(Context &context, GLenum target, GLenum pname, const T *params, bool scalar, Host host) {
  if (target == GL_POINT_SPRITE && params && recordCoordReplace(context, pname, GLint(params[0])))
    return;
  if (target == GL_TEXTURE_ENV && hasBumpMaps(context) && setBump(context, pname, params))
    return;
  if (!context.textureShaders) [[likely]]
    return host();
  if (hasTextureShaders(context)) {
    if (target == GL_TEXTURE_SHADER_NV)
      return setShader(context, pname, params, scalar);
    if (setMode(context, target, pname, params))
      return;
  }
  host();
  if (pname != GL_TEXTURE_ENV_COLOR)
    noteEnvironmentCommand(context);
}

template <typename T> void give(GLfloat value, T *to) {
  if constexpr (std::is_integral_v<T>)
    *to = T(std::lround(value));
  else
    *to = value;
}
template <typename T> void give(const Vec4 &values, int first, int count, T *to) {
  for (int i = 0; i < count; ++i)
    give(values[std::size_t(first + i)], to + i);
}

/// Executes GetTexEnv of TEXTURE_SHADER_NV.
template <typename T> void getShader(Context &context, GLenum pname, T *params) {
  if (!outsideBeginEnd(context, "GetTexEnv between Begin and End"))
    return;
  const TextureShaderState &shaders = *context.textureShaders;
  const GLuint unit = activeUnit(context);
  if (textureShaderValues(pname) == 0 && pname != GL_SHADER_CONSISTENT_NV)
    return raise(context, GL_INVALID_ENUM, "GetTexEnv: pname of TEXTURE_SHADER_NV");
  if (unit >= GLuint(shaders.units()))
    return raise(context, GL_INVALID_OPERATION, "GetTexEnv: the active unit has no environment");
  const Stage &stage = shaders.now().stages[unit];
  const auto &rows = shaders.now().rows[unit];
  switch (pname) {
  case GL_SHADER_CONSISTENT_NV:
    *params = T(stageIsConsistent(context, int(unit)) ? GL_TRUE : GL_FALSE);
    return;
  case GL_SHADER_OPERATION_NV:
    *params = T(enumerants::nameOf(stage.operation));
    return;
  case GL_PREVIOUS_TEXTURE_INPUT_NV:
    *params = T(GL_TEXTURE0 + stage.previous);
    return;
  case GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV:
    *params = T(enumerants::nameOf(stage.mapping));
    return;
  case GL_CULL_MODES_NV:
    for (unsigned i = 0; i < 4; ++i)
      params[i] = T((stage.cullLess >> i & 1u) != 0 ? GL_LESS : GL_GEQUAL);
    return;
  case GL_OFFSET_TEXTURE_MATRIX_NV:
    return give(rows[std::size_t(Row::Matrix)], 0, 4, params);
  case GL_CONST_EYE_NV:
    return give(rows[std::size_t(Row::Eye)], 0, 3, params);
  default:
    return give(rows[std::size_t(Row::ScaleBias)], pname == GL_OFFSET_TEXTURE_SCALE_NV ? 0 : 1, 1,
                params);
  }
}

/// Gets a value of ATI_envmap_bumpmap. Returns false for other names.
template <typename T> bool getBump(Context &context, GLenum pname, T *params) {
  if (pname != GL_BUMP_TARGET_ATI && pname != GL_COMBINE_RGB)
    return false;
  const TextureShaderSettings fresh;
  const TextureShaderSettings &now = context.textureShaders ? context.textureShaders->now() : fresh;
  const GLuint unit = activeUnit(context);
  if (unit >= now.bumpTargets.size())
    return false;
  if (pname == GL_COMBINE_RGB && (now.bumps >> unit & 1) == 0)
    return false;
  *params = T(pname == GL_COMBINE_RGB ? GLenum(GL_BUMP_ENVMAP_ATI)
                                      : GLenum(GL_TEXTURE0 + now.bumpTargets[unit]));
  return true;
}

template <typename T, typename Host>
void getEnvironment(Context &context, GLenum target, GLenum pname, T *params, Host host) {
  if (target == GL_POINT_SPRITE)
    releaseSprites(context);
  if (target == GL_TEXTURE_ENV && params && !context.insideBeginEnd && hasBumpMaps(context) &&
      getBump(context, pname, params))
    return;
  if (hasTextureShaders(context) && params && !context.insideBeginEnd) {
    if (target == GL_TEXTURE_SHADER_NV)
      return getShader(context, pname, params);
    const std::uint8_t none = context.textureShaders->now().environmentNone;
    if (none != 0 && target == GL_TEXTURE_ENV && pname == GL_TEXTURE_ENV_MODE)
      if (const GLuint unit = activeUnit(context); unit < 8 && (none >> unit & 1u) != 0) {
        *params = T(GL_NONE);
        return;
      }
  }
  host();
}

} // namespace

namespace handlers {

void TexEnvf(Context &context, GLenum target, GLenum pname, GLfloat param) {
  set(context, target, pname, &param, true, [&] { context.host->TexEnvf(target, pname, param); });
}
void TexEnvi(Context &context, GLenum target, GLenum pname, GLint param) {
  set(context, target, pname, &param, true, [&] { context.host->TexEnvi(target, pname, param); });
}
void TexEnvfv(Context &context, GLenum target, GLenum pname, const GLfloat *params) {
  set(context, target, pname, params, false,
      [&] { context.host->TexEnvfv(target, pname, params); });
}
void TexEnviv(Context &context, GLenum target, GLenum pname, const GLint *params) {
  set(context, target, pname, params, false,
      [&] { context.host->TexEnviv(target, pname, params); });
}
void GetTexEnvfv(Context &context, GLenum target, GLenum pname, GLfloat *params) {
  getEnvironment(context, target, pname, params,
                 [&] { context.host->GetTexEnvfv(target, pname, params); });
}
void GetTexEnviv(Context &context, GLenum target, GLenum pname, GLint *params) {
  getEnvironment(context, target, pname, params,
                 [&] { context.host->GetTexEnviv(target, pname, params); });
}

} // namespace handlers
} // namespace arbiter::state
