#include "apps/tools/draw/gl_state_text.h"

#include <algorithm>

#include "enumerants/combiners.h"
#include "enumerants/texture_shaders.h"
#include "fp_compiler/front/nvparse/limits.h"
#include "fp_compiler/texture_shader/operations.h"

namespace arbiter::tools {

namespace {

using enumerants::nameOf;
using fp::combiners::Portion;
using fp::texture_shader::Row;

void issue(GLenum stage, GLenum half, const Portion &portion) {
  for (std::size_t v = 0; v < portion.inputs.size(); ++v)
    glCombinerInputNV(stage, half, GLenum(GL_VARIABLE_A_NV + v), nameOf(portion.inputs[v].source),
                      nameOf(portion.inputs[v].mapping), nameOf(portion.inputs[v].usage));
  glCombinerOutputNV(stage, half, nameOf(portion.ab), nameOf(portion.cd), nameOf(portion.sum),
                     nameOf(portion.scale),
                     portion.bias ? GL_BIAS_BY_NEGATIVE_ONE_HALF_NV : GL_NONE,
                     GLboolean(portion.abDot), GLboolean(portion.cdDot), GLboolean(portion.mux));
}

void issue(const fp::combiners::State &state) {
  glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, state.count);
  glCombinerParameteriNV(GL_COLOR_SUM_CLAMP_NV, state.sumClamp ? 1 : 0);
  for (std::size_t i = 0; i < state.count; ++i) {
    issue(GLenum(GL_COMBINER0_NV + i), GL_RGB, state.stages[i].rgb);
    issue(GLenum(GL_COMBINER0_NV + i), GL_ALPHA, state.stages[i].alpha);
  }
  for (std::size_t v = 0; v < state.finals.size(); ++v)
    glFinalCombinerInputNV(GLenum(GL_VARIABLE_A_NV + v), nameOf(state.finals[v].source),
                           nameOf(state.finals[v].mapping), nameOf(state.finals[v].usage));
  if (state.perStageConstants)
    glEnable(GL_PER_STAGE_CONSTANTS_NV);
  else if (epoxy_has_gl_extension("GL_NV_register_combiners2"))
    glDisable(GL_PER_STAGE_CONSTANTS_NV);
  glEnable(GL_REGISTER_COMBINERS_NV);
}

void issue(const fp::texture_shader::State &state) {
  for (std::size_t unit = 0; unit < state.units; ++unit) {
    const fp::texture_shader::Stage &stage = state.stages[unit];
    const auto family = fp::texture_shader::infoOf(stage.operation).family;
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    const auto set = [](GLenum pname, GLenum value) {
      glTexEnvi(GL_TEXTURE_SHADER_NV, pname, GLint(value));
    };
    set(GL_SHADER_OPERATION_NV, nameOf(stage.operation));
    if (fp::texture_shader::readsPrevious(family))
      set(GL_PREVIOUS_TEXTURE_INPUT_NV, GLenum(GL_TEXTURE0 + stage.previous));
    if (fp::texture_shader::computesDot(family))
      set(GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV, nameOf(stage.mapping));
    if (family == fp::texture_shader::Family::Cull) {
      GLint modes[4];
      for (unsigned i = 0; i < 4; ++i)
        modes[i] = (stage.cullLess >> i & 1u) != 0 ? GL_LESS : GL_GEQUAL;
      glTexEnviv(GL_TEXTURE_SHADER_NV, GL_CULL_MODES_NV, modes);
    }
  }
  glActiveTexture(GL_TEXTURE0);
  glEnable(GL_TEXTURE_SHADER_NV);
}

} // namespace

fp::Limits stateTextLimits() {
  const auto has = [](const char *name) { return epoxy_has_gl_extension(name); };
  fp::Limits limits;
  GLint units = 0, stages = 0;
  glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
  if (has("GL_NV_register_combiners"))
    glGetIntegerv(GL_MAX_GENERAL_COMBINERS_NV, &stages);
  limits.textureUnits = std::uint32_t(std::clamp(units, 1, fp::texture_shader::kUnits));
  limits.generalCombiners = std::uint32_t(std::max(stages, 0));
  limits.perStageConstants = has("GL_NV_register_combiners2") ? 1 : 0;
  limits.textureShaders = has("GL_NV_texture_shader3")   ? 3
                          : has("GL_NV_texture_shader2") ? 2
                          : has("GL_NV_texture_shader")  ? 1
                                                         : 0;
  return fp::nvparse::limitsOf(limits);
}

void giveStateValue(int parameter, const fp::ir::Vec4 &value) {
  if (parameter < 2)
    return glCombinerParameterfvNV(GLenum(GL_CONSTANT_COLOR0_NV + parameter), value.data());
  if (parameter < fp::combiners::kConstants)
    return glCombinerStageParameterfvNV(GLenum(GL_COMBINER0_NV + (parameter - 2) / 2),
                                        GLenum(GL_CONSTANT_COLOR0_NV + parameter % 2),
                                        value.data());
  const int row = parameter - fp::combiners::kConstants;
  glActiveTexture(GLenum(GL_TEXTURE0 + row / 3));
  switch (Row(row % 3)) {
  case Row::Matrix:
    glTexEnvfv(GL_TEXTURE_SHADER_NV, GL_OFFSET_TEXTURE_MATRIX_NV, value.data());
    break;
  case Row::ScaleBias:
    glTexEnvf(GL_TEXTURE_SHADER_NV, GL_OFFSET_TEXTURE_SCALE_NV, value[0]);
    glTexEnvf(GL_TEXTURE_SHADER_NV, GL_OFFSET_TEXTURE_BIAS_NV, value[1]);
    break;
  case Row::Eye:
    glTexEnvfv(GL_TEXTURE_SHADER_NV, GL_CONST_EYE_NV, value.data());
    break;
  case Row::Bump: // no text sets it
    break;
  }
  glActiveTexture(GL_TEXTURE0);
}

void issueStateText(const fp::nvparse::Text &text) {
  if (text.shaders)
    issue(*text.shaders);
  if (text.combiners)
    issue(*text.combiners);
  for (std::size_t i = 0; i < text.values.size(); ++i)
    if (text.values[i])
      giveStateValue(int(i), *text.values[i]);
}

void disableStateTexts() {
  if (epoxy_has_gl_extension("GL_NV_register_combiners"))
    glDisable(GL_REGISTER_COMBINERS_NV);
  if (epoxy_has_gl_extension("GL_NV_texture_shader"))
    glDisable(GL_TEXTURE_SHADER_NV);
}

} // namespace arbiter::tools
