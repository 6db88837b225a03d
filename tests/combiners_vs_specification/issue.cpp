#include "issue.h"

#include <array>

namespace combined {

using namespace arbiter::fp::combiners;

namespace {

GLenum nameOf(Register name) {
  constexpr GLenum kNames[] = {GL_ZERO,      GL_CONSTANT_COLOR0_NV, GL_CONSTANT_COLOR1_NV,
                               GL_FOG,       GL_PRIMARY_COLOR_NV,   GL_SECONDARY_COLOR_NV,
                               GL_SPARE0_NV, GL_SPARE1_NV};
  if (const int unit = textureUnit(name); unit >= 0)
    return GLenum(GL_TEXTURE0 + unit);
  if (name == Register::ETimesF)
    return GL_E_TIMES_F_NV;
  if (name == Register::Spare0PlusSecondary)
    return GL_SPARE0_PLUS_SECONDARY_COLOR_NV;
  return name == Register::Discard ? GLenum(GL_DISCARD_NV) : kNames[std::size_t(name)];
}

GLenum nameOf(Mapping mapping) {
  constexpr GLenum kNames[] = {
      GL_UNSIGNED_IDENTITY_NV, GL_UNSIGNED_INVERT_NV,  GL_EXPAND_NORMAL_NV,   GL_EXPAND_NEGATE_NV,
      GL_HALF_BIAS_NORMAL_NV,  GL_HALF_BIAS_NEGATE_NV, GL_SIGNED_IDENTITY_NV, GL_SIGNED_NEGATE_NV};
  return kNames[std::size_t(mapping)];
}

GLenum nameOf(Usage usage) {
  constexpr GLenum kNames[] = {GL_RGB, GL_ALPHA, GL_BLUE};
  return kNames[std::size_t(usage)];
}

GLenum nameOf(Scale scale) {
  constexpr GLenum kNames[] = {GL_NONE, GL_SCALE_BY_TWO_NV, GL_SCALE_BY_FOUR_NV,
                               GL_SCALE_BY_ONE_HALF_NV};
  return kNames[std::size_t(scale)];
}

void issuePortion(GLenum stage, GLenum name, const Portion &portion) {
  for (unsigned v = 0; v < 4; ++v) {
    const Input &input = portion.inputs[v];
    glCombinerInputNV(stage, name, GL_VARIABLE_A_NV + v, nameOf(input.source),
                      nameOf(input.mapping), nameOf(input.usage));
  }
  glCombinerOutputNV(stage, name, nameOf(portion.ab), nameOf(portion.cd), nameOf(portion.sum),
                     nameOf(portion.scale),
                     portion.bias ? GL_BIAS_BY_NEGATIVE_ONE_HALF_NV : GL_NONE, portion.abDot,
                     portion.cdDot, portion.mux);
}

std::array<GLfloat, 4> single(const Color &c) {
  return {GLfloat(c[0]), GLfloat(c[1]), GLfloat(c[2]), GLfloat(c[3])};
}

} // namespace

void issue(const State &state) {
  glEnable(GL_REGISTER_COMBINERS_NV);
  (state.perStageConstants ? glEnable : glDisable)(GL_PER_STAGE_CONSTANTS_NV);
  glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, state.count);
  glCombinerParameteriNV(GL_COLOR_SUM_CLAMP_NV, state.sumClamp);
  for (unsigned i = 0; i < state.count; ++i) {
    issuePortion(GL_COMBINER0_NV + i, GL_RGB, state.stages[i].rgb);
    issuePortion(GL_COMBINER0_NV + i, GL_ALPHA, state.stages[i].alpha);
  }
  for (unsigned v = 0; v < state.finals.size(); ++v)
    glFinalCombinerInputNV(GL_VARIABLE_A_NV + v, nameOf(state.finals[v].source),
                           nameOf(state.finals[v].mapping), nameOf(state.finals[v].usage));
}

void issueConstants(const Inputs &inputs, int stages) {
  for (unsigned which = 0; which < 2; ++which) {
    const GLenum name = GL_CONSTANT_COLOR0_NV + which;
    glCombinerParameterfvNV(
        name, single(inputs.constants[std::size_t(globalConstant(int(which)))]).data());
    for (int stage = 0; stage < stages; ++stage)
      glCombinerStageParameterfvNV(
          GLenum(GL_COMBINER0_NV + stage), name,
          single(inputs.constants[std::size_t(stageConstant(stage, int(which)))]).data());
  }
}

} // namespace combined
