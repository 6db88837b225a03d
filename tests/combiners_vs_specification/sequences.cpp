// sequences [--first SEED] [--count N]: issues sequences of commands of NV_register_combiners and
// 2. Their arguments are valid and invalid names, some commands are in display lists, some between
// PushAttrib and PopAttrib. A model from the specifications' sections Errors and New State predicts
// each command's error and the whole state after each sequence. Ends with a line of JSON.
#include <cstdio>

#include <epoxy/gl.h>

#include "client_options.h"
#include "command_model.h"
#include "open_context.h"

namespace {

using namespace commanded;
using arbiter::fp::testing::Random;

constexpr int kCommands = 100; ///< in a sequence

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

struct Tally {
  long commands = 0, errors = 0, listed = 0, saved = 0;
};

bool isExpected(std::uint64_t seed, int at, const Command &command, GLenum expected) {
  const GLenum got = glGetError();
  while (glGetError() != GL_NO_ERROR) {
  }
  if (got == expected)
    return true;
  std::printf("seed %llu, command %d: error 0x%04X, expected 0x%04X; kind %d",
              static_cast<unsigned long long>(seed), at, got, expected, command.kind);
  for (const GLenum name : command.names)
    std::printf(" 0x%04X", name);
  std::printf(" number %d\n", command.number);
  return false;
}

/// Runs one sequence; the state continues from the previous one.
bool run(std::uint64_t seed, int units, Model &model, Tally &tally) {
  Random random(seed);
  const Model before = model;
  const bool saves = random.chance(25), lists = random.chance(25);
  if (saves)
    glPushAttrib(GL_TEXTURE_BIT);
  const GLuint list = lists ? glGenLists(1) : 0;
  if (lists)
    glNewList(list, GL_COMPILE);
  GLenum firstError = GL_NO_ERROR;
  bool same = true;
  for (int i = 0; i < kCommands; ++i) {
    const Command command = randomCommand(random, units);
    const GLenum error = apply(model, command, units);
    issue(command);
    ++tally.commands;
    tally.errors += error != GL_NO_ERROR ? 1 : 0;
    if (firstError == GL_NO_ERROR)
      firstError = error;
    same = isExpected(seed, i, command, lists ? GLenum(GL_NO_ERROR) : error) && same;
  }
  if (lists) {
    glEndList();
    glCallList(list);
    same = isExpected(seed, kCommands, {.kind = -1}, firstError) && same;
    glDeleteLists(list, 1);
    tally.listed += kCommands;
  }
  const auto agrees = [&](const char *when) {
    if (queried() == model)
      return true;
    std::printf("seed %llu: the state %s is another than the model's\n",
                static_cast<unsigned long long>(seed), when);
    return false;
  };
  same = agrees("behind the sequence") && same;
  if (saves) {
    glPopAttrib();
    model = before;
    ++tally.saved;
    same = agrees("behind PopAttrib") && same;
  }
  return same;
}

} // namespace

int main(int argc, char **argv) {
  Seeds seeds;
  if (const auto status =
          parseOptions(argc, argv, "Issues random commands and compares errors and state.", seeds))
    return *status;
  if (!openContextWith("GL_NV_register_combiners2"))
    return kSkipped;
  GLint units = 0;
  glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
  Model model;
  Tally tally;
  int different = 0;
  for (std::uint64_t seed = seeds.first; seed < seeds.last(); ++seed)
    different += run(seed, units, model, tally) ? 0 : 1;
  std::printf("{\"sequences\": %d, \"different\": %d, \"commands\": %ld, \"errors\": %ld, "
              "\"in_lists\": %ld, \"saved\": %ld}\n",
              seeds.count, different, tally.commands, tally.errors, tally.listed, tally.saved);
  return different == 0 ? 0 : 1;
}
