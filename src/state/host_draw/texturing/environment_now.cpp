#include "state/host_draw/texturing/environment_now.h"

#include <algorithm>
#include <iterator>

#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/core/unit_scope.h"
#include "state/host_draw/draw_context.h"
#include "state/programs/texture_shaders/texture_shader_state.h"

namespace arbiter::state {

namespace {

using fp::texture_shader::CombineArgument;
using fp::texture_shader::CombineFunction;
using fp::texture_shader::CombineHalf;
using fp::texture_shader::CombineSource;
using fp::texture_shader::Environment;
using fp::texture_shader::EnvironmentMode;

/// The values of CombineFunction, without the last three.
constexpr GLenum kFunctions[] = {GL_REPLACE,
                                 GL_MODULATE,
                                 GL_ADD,
                                 GL_ADD_SIGNED,
                                 GL_INTERPOLATE,
                                 GL_SUBTRACT,
                                 GL_DOT3_RGB,
                                 GL_DOT3_RGBA,
                                 GL_MODULATE_ADD_ATI,
                                 GL_MODULATE_SIGNED_ADD_ATI,
                                 GL_MODULATE_SUBTRACT_ATI};

CombineSource sourceOf(GLint name) {
  switch (name) {
  case GL_CONSTANT:
    return CombineSource::Constant;
  case GL_PRIMARY_COLOR:
    return CombineSource::Primary;
  case GL_PREVIOUS:
    return CombineSource::Previous;
  case GL_ZERO:
    return CombineSource::Zero;
  case GL_ONE:
    return CombineSource::One;
  default:
    break;
  }
  const auto unit = unsigned(name) - unsigned(GL_TEXTURE0);
  return unit < unsigned(fp::texture_shader::kUnits)
             ? CombineSource(unsigned(CombineSource::Unit0) + unit)
             : CombineSource::Texture;
}

/// Queries one half of COMBINE. The enumerants of RGB's and alpha's halves differ by a fixed
/// distance, and those of the fourth argument follow the third's.
CombineHalf halfOf(const host::HostTable &host, bool alpha, bool four) {
  CombineHalf half;
  const auto function = GLenum(hostEnvironment(host, alpha ? GL_COMBINE_ALPHA : GL_COMBINE_RGB));
  const auto *const row = std::find(std::begin(kFunctions), std::end(kFunctions), function);
  half.function = row == std::end(kFunctions) ? CombineFunction::Modulate
                                              : CombineFunction(row - std::begin(kFunctions));
  if (four)
    half.function = function == GL_ADD_SIGNED ? CombineFunction::AddSignedProducts
                                              : CombineFunction::AddProducts;
  for (int i = 0; i < fp::texture_shader::argumentsOf(half.function); ++i) {
    const GLenum source = GLenum(alpha ? GL_SOURCE0_ALPHA : GL_SOURCE0_RGB) + GLenum(i);
    const GLenum operand = GLenum(alpha ? GL_OPERAND0_ALPHA : GL_OPERAND0_RGB) + GLenum(i);
    const GLint how = hostEnvironment(host, operand);
    half.arguments[std::size_t(i)] = {sourceOf(hostEnvironment(host, source)),
                                      how == GL_SRC_ALPHA || how == GL_ONE_MINUS_SRC_ALPHA,
                                      how == GL_ONE_MINUS_SRC_COLOR ||
                                          how == GL_ONE_MINUS_SRC_ALPHA};
  }
  GLfloat scale = 1;
  host.GetTexEnvfv(GL_TEXTURE_ENV, alpha ? GL_ALPHA_SCALE : GL_RGB_SCALE, &scale);
  half.scale = std::uint8_t(scale);
  return half;
}

/// Queries the active unit's environment.
Environment environmentOf(const host::HostTable &host) {
  Environment environment;
  const GLint mode = hostEnvironment(host, GL_TEXTURE_ENV_MODE);
  switch (mode) {
  case GL_REPLACE:
    environment.mode = EnvironmentMode::Replace;
    break;
  case GL_DECAL:
    environment.mode = EnvironmentMode::Decal;
    break;
  case GL_BLEND:
    environment.mode = EnvironmentMode::Blend;
    break;
  case GL_ADD:
    environment.mode = EnvironmentMode::Add;
    break;
  case GL_COMBINE:
  case GL_COMBINE4_NV: {
    environment.mode = EnvironmentMode::Combine;
    environment.color = halfOf(host, false, mode == GL_COMBINE4_NV);
    environment.alpha = halfOf(host, true, mode == GL_COMBINE4_NV);
    break;
  }
  default:
    environment.mode = EnvironmentMode::Modulate;
  }
  return environment;
}

} // namespace

fp::texture_shader::Environments environmentsNow(DrawContext &context) {
  fp::texture_shader::Environments environments;
  const TextureShaderState &shaders = *context.textureShaders;
  for (int unit = 0; unit < shaders.units(); ++unit) {
    if ((shaders.now().environmentNone >> unit & 1) != 0)
      continue;
    const UnitScope scope(*context.host, unsigned(unit));
    Environment &environment = environments[std::size_t(unit)];
    environment = environmentOf(*context.host);
    if ((shaders.now().bumps >> unit & 1) != 0 && environment.mode == EnvironmentMode::Combine)
      environment.color = {.function = CombineFunction::BumpEnvmap};
  }
  return environments;
}

} // namespace arbiter::state
