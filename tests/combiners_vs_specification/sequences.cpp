// sequences [--first SEED] [--count N]: issues sequences of commands of NV_register_combiners and
// 2. Their arguments are valid and invalid names, some commands are in display lists, some between
// PushAttrib and PopAttrib. A model from the specifications' sections Errors and New State predicts
// each command's error and the whole state after each sequence. Ends with a line of JSON.
#include <cstdio>

#include <epoxy/gl.h>

#include "command_model.h"
#include "command_sequences.h"

namespace {

using namespace commanded;
using arbiter::fp::testing::Random;

void issue(const Command &c) {
  const auto &n = c.names;
  switch (c.kind) {
  case 0:
    return glCombinerInputNV(n[0], n[1], n[2], n[3], n[4], n[5]);
  case 1:
    return glCombinerOutputNV(n[0], n[1], n[2], n[3], n[4], n[5], n[6], c.flags[0], c.flags[1],
                              c.flags[2]);
  case 2:
    return glFinalCombinerInputNV(n[0], n[1], n[2], n[3]);
  case 3:
    return glCombinerParameterfvNV(n[0], c.color.data());
  case 4:
    return glCombinerStageParameterfvNV(n[0], n[1], c.color.data());
  case 5:
    if (c.flags[0])
      return glCombinerParameterfNV(n[0], GLfloat(c.number));
    return glCombinerParameteriNV(n[0], c.number);
  default: {
    const GLenum cap = c.kind == 6 ? GL_REGISTER_COMBINERS_NV : GL_PER_STAGE_CONSTANTS_NV;
    return c.flags[0] ? glEnable(cap) : glDisable(cap);
  }
  }
}

// --- What GL has ---

Half queriedHalf(GLenum stage, GLenum portion) {
  Half half;
  for (GLenum v = 0; v < 4; ++v) {
    const auto get = [&](GLenum pname) {
      GLint value = 0;
      glGetCombinerInputParameterivNV(stage, portion, GL_VARIABLE_A_NV + v, pname, &value);
      return GLenum(value);
    };
    half.variables[v] = {get(GL_COMBINER_INPUT_NV), get(GL_COMBINER_MAPPING_NV),
                         get(GL_COMBINER_COMPONENT_USAGE_NV)};
  }
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    glGetCombinerOutputParameterivNV(stage, portion, pname, &value);
    return GLenum(value);
  };
  half.ab = get(GL_COMBINER_AB_OUTPUT_NV);
  half.cd = get(GL_COMBINER_CD_OUTPUT_NV);
  half.sum = get(GL_COMBINER_SUM_OUTPUT_NV);
  half.scale = get(GL_COMBINER_SCALE_NV);
  half.bias = get(GL_COMBINER_BIAS_NV);
  half.abDot = get(GL_COMBINER_AB_DOT_PRODUCT_NV) != 0;
  half.cdDot = get(GL_COMBINER_CD_DOT_PRODUCT_NV) != 0;
  half.mux = get(GL_COMBINER_MUX_SUM_NV) != 0;
  return half;
}

Model queried() {
  Model model;
  for (GLuint stage = 0; stage < kStages; ++stage) {
    model.stages[stage] = {queriedHalf(GL_COMBINER0_NV + stage, GL_RGB),
                           queriedHalf(GL_COMBINER0_NV + stage, GL_ALPHA)};
    for (GLenum which = 0; which < 2; ++which)
      glGetCombinerStageParameterfvNV(GL_COMBINER0_NV + stage, GL_CONSTANT_COLOR0_NV + which,
                                      model.stageConstants[stage][which].data());
  }
  for (GLenum v = 0; v < 7; ++v) {
    const auto get = [&](GLenum pname) {
      GLint value = 0;
      glGetFinalCombinerInputParameterivNV(GL_VARIABLE_A_NV + v, pname, &value);
      return GLenum(value);
    };
    model.finals[v] = {get(GL_COMBINER_INPUT_NV), get(GL_COMBINER_MAPPING_NV),
                       get(GL_COMBINER_COMPONENT_USAGE_NV)};
  }
  for (GLenum which = 0; which < 2; ++which)
    glGetFloatv(GL_CONSTANT_COLOR0_NV + which, model.constants[which].data());
  glGetIntegerv(GL_NUM_GENERAL_COMBINERS_NV, &model.count);
  GLboolean value = GL_FALSE;
  glGetBooleanv(GL_COLOR_SUM_CLAMP_NV, &value);
  model.sumClamp = value != GL_FALSE;
  model.enabled = glIsEnabled(GL_REGISTER_COMBINERS_NV) != GL_FALSE;
  model.perStage = glIsEnabled(GL_PER_STAGE_CONSTANTS_NV) != GL_FALSE;
  return model;
}

struct Combiners {
  using Command = commanded::Command;
  using Model = commanded::Model;
  static constexpr const char *kExtension = "GL_NV_register_combiners2";
  static constexpr int kMaxUnits = 1 << 8;
  static constexpr bool kListsRaise = true;

  static Command random(Random &random, int units) { return randomCommand(random, units); }
  static GLenum apply(Model &model, const Command &command, int units) {
    return commanded::apply(model, command, units);
  }
  static void issue(const Command &command) { ::issue(command); }
  static Model queried(int) { return ::queried(); }
  static void print(const Command &command) {
    std::printf("kind %d", command.kind);
    for (const GLenum name : command.names)
      std::printf(" 0x%04X", name);
    std::printf(" number %d\n", command.number);
  }
};

} // namespace

int main(int argc, char **argv) { return CommandSequences<Combiners>::main(argc, argv); }
