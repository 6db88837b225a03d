#include "state/programs/combiners/combiner_commands.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include <GL/glext.h>

#include "enumerants/combiners.h"
#include "state/core/errors.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/program_context.h"

namespace arbiter::state {

namespace {

using namespace fp::combiners;

static_assert(std::is_trivially_copyable_v<CombinerCommand>);

/// An error of a command.
struct Wrong {
  GLenum error = GL_NO_ERROR;
  const char *why = "";
};

Vec4 clamped(const Vec4 &color) {
  Vec4 result = color;
  for (GLfloat &c : result)
    c = std::clamp(c, 0.0f, 1.0f);
  return result;
}

/// Returns the number of an offered stage, or -1.
int stageOf(const CombinerState &combiners, GLenum name) {
  const GLenum stage = name - GL_COMBINER0_NV;
  return stage < GLenum(combiners.stages()) ? int(stage) : -1;
}

Wrong parameter(ProgramContext &context, CombinerState &combiners, const CombinerCommand &command) {
  switch (command.names[0]) {
  case GL_CONSTANT_COLOR0_NV:
  case GL_CONSTANT_COLOR1_NV:
    if (command.scalar)
      return {GL_INVALID_ENUM, "CombinerParameter: a colour is of four values"};
    combiners.setConstant(context, globalConstant(int(command.names[0] - GL_CONSTANT_COLOR0_NV)),
                          clamped(command.values));
    return {};
  case GL_NUM_GENERAL_COMBINERS_NV: {
    const GLfloat count = command.values[0];
    if (!(count >= 1.0f) || count > GLfloat(combiners.stages()))
      return {GL_INVALID_VALUE, "CombinerParameter: NUM_GENERAL_COMBINERS_NV"};
    combiners.set(
        context, [](auto &state) -> auto & { return state.count; }, std::uint8_t(count));
    return {};
  }
  case GL_COLOR_SUM_CLAMP_NV:
    combiners.set(
        context, [](auto &state) -> auto & { return state.sumClamp; }, command.values[0] != 0.0f);
    return {};
  default:
    return {GL_INVALID_ENUM, "CombinerParameter: pname"};
  }
}

Wrong stageParameter(ProgramContext &context, CombinerState &combiners,
                     const CombinerCommand &command) {
  const int stage = stageOf(combiners, command.names[0]);
  const GLenum which = command.names[1] - GL_CONSTANT_COLOR0_NV;
  if (stage < 0 || which > 1)
    return {GL_INVALID_ENUM, "CombinerStageParameter: stage or pname"};
  combiners.setConstant(context, stageConstant(stage, int(which)), clamped(command.values));
  return {};
}

/// Executes CombinerInput (3.8.12.2).
Wrong input(ProgramContext &context, CombinerState &combiners, const CombinerCommand &command) {
  const auto [stageName, portion, variableName, source, mappingName, usageName, unused] =
      command.names;
  const int stage = stageOf(combiners, stageName);
  const GLenum variable = variableName - GL_VARIABLE_A_NV;
  const auto from = enumerants::inputRegister(source, combiners.units());
  const auto mapping = enumerants::combinerMapping(mappingName);
  const auto usage = enumerants::componentUsage(usageName);
  const bool alpha = portion == GL_ALPHA;
  if (stage < 0 || (portion != GL_RGB && !alpha) || variable > 3 || !from || !mapping || !usage)
    return {GL_INVALID_ENUM, "CombinerInput: an argument is none of its names"};
  if (*usage == (alpha ? Usage::Rgb : Usage::Blue))
    return {GL_INVALID_OPERATION, "CombinerInput: the portion does not take this componentUsage"};
  if (*usage == Usage::Alpha && *from == Register::Fog)
    return {GL_INVALID_OPERATION, "CombinerInput: the alpha of FOG is the final combiner's"};
  combiners.set(
      context,
      [&](auto &state) -> auto & {
        auto &of = state.stages[std::size_t(stage)];
        return (alpha ? of.alpha : of.rgb).inputs[variable];
      },
      Input{*from, *mapping, *usage});
  return {};
}

bool areUnique(const Portion &portion) {
  const auto same = [](Register a, Register b) { return a == b && a != Register::Discard; };
  return !same(portion.ab, portion.cd) && !same(portion.ab, portion.sum) &&
         !same(portion.cd, portion.sum);
}

Wrong output(ProgramContext &context, CombinerState &combiners, const CombinerCommand &command) {
  const auto [stageName, portionName, abName, cdName, sumName, scaleName, bias] = command.names;
  const int stage = stageOf(combiners, stageName);
  const auto ab = enumerants::outputRegister(abName, combiners.units());
  const auto cd = enumerants::outputRegister(cdName, combiners.units());
  const auto sum = enumerants::outputRegister(sumName, combiners.units());
  const auto scale = enumerants::combinerScale(scaleName);
  const bool alpha = portionName == GL_ALPHA;
  if (stage < 0 || (portionName != GL_RGB && !alpha) || !ab || !cd || !sum || !scale ||
      (bias != GL_NONE && bias != GL_BIAS_BY_NEGATIVE_ONE_HALF_NV))
    return {GL_INVALID_ENUM, "CombinerOutput: an argument is none of its names"};
  if (alpha && (command.flags & (CombinerCommand::kAbDot | CombinerCommand::kCdDot)) != 0)
    return {GL_INVALID_VALUE, "CombinerOutput: the alpha portion has no dot products"};
  if (bias != GL_NONE &&
      (*scale == fp::combiners::Scale::ByFour || *scale == fp::combiners::Scale::ByOneHalf))
    return {GL_INVALID_OPERATION, "CombinerOutput: this scale goes with no bias"};
  Portion result = alpha ? combiners.state().stages[std::size_t(stage)].alpha
                         : combiners.state().stages[std::size_t(stage)].rgb;
  result.ab = *ab;
  result.cd = *cd;
  result.sum = *sum;
  result.scale = *scale;
  result.bias = bias != GL_NONE;
  result.abDot = (command.flags & CombinerCommand::kAbDot) != 0;
  result.cdDot = (command.flags & CombinerCommand::kCdDot) != 0;
  result.mux = (command.flags & CombinerCommand::kMux) != 0;
  if (!areUnique(result))
    return {GL_INVALID_OPERATION, "CombinerOutput: two results into one register"};
  combiners.set(
      context,
      [&](auto &state) -> auto & {
        auto &of = state.stages[std::size_t(stage)];
        return alpha ? of.alpha : of.rgb;
      },
      result);
  return {};
}

/// Executes FinalCombinerInput (3.8.12.3).
Wrong finalInput(ProgramContext &context, CombinerState &combiners,
                 const CombinerCommand &command) {
  const GLenum variable = command.names[0] - GL_VARIABLE_A_NV;
  const auto from = enumerants::finalInputRegister(command.names[1], combiners.units());
  const auto mapping = enumerants::combinerMapping(command.names[2]);
  const auto usage = enumerants::componentUsage(command.names[3]);
  if (variable > 6 || !from || !mapping || *mapping > Mapping::UnsignedInvert || !usage)
    return {GL_INVALID_ENUM, "FinalCombinerInput: an argument is none of its names"};
  const bool pseudo = *from == Register::ETimesF || *from == Register::Spare0PlusSecondary;
  if (pseudo && (variable > 3 || (variable == 0 && *from == Register::Spare0PlusSecondary)))
    return {GL_INVALID_OPERATION, "FinalCombinerInput: this variable does not take this input"};
  if (*usage == (variable == 6 ? Usage::Rgb : Usage::Blue))
    return {GL_INVALID_OPERATION,
            "FinalCombinerInput: this variable does not take this componentUsage"};
  if (pseudo && *usage != Usage::Rgb)
    return {GL_INVALID_OPERATION, "FinalCombinerInput: this input has colours alone"};
  combiners.set(
      context, [&](auto &state) -> auto & { return state.finals[variable]; },
      Input{*from, *mapping, *usage});
  return {};
}

Wrong executed(ProgramContext &context, CombinerState &combiners, const CombinerCommand &command) {
  switch (command.kind) {
  case CombinerCommand::Kind::Parameter:
    return parameter(context, combiners, command);
  case CombinerCommand::Kind::StageParameter:
    return stageParameter(context, combiners, command);
  case CombinerCommand::Kind::Input:
    return input(context, combiners, command);
  case CombinerCommand::Kind::Output:
    return output(context, combiners, command);
  case CombinerCommand::Kind::FinalInput:
    return finalInput(context, combiners, command);
  case CombinerCommand::Kind::PerStageConstants:
    combiners.set(
        context, [](auto &state) -> auto & { return state.perStageConstants; },
        (command.flags & CombinerCommand::kOn) != 0);
    return {};
  }
  return {};
}

} // namespace

void executeCombinerCommand(ProgramContext &context, const CombinerCommand &command) {
  if (const Wrong wrong = executed(context, *context.combiners, command);
      wrong.error != GL_NO_ERROR)
    raise(context, wrong.error, wrong.why);
}

std::string bytesOf(const CombinerCommand &command) {
  return {reinterpret_cast<const char *>(&command), sizeof command};
}

void executeCombinerCommands(ProgramContext &context, const std::string &bytes) {
  if (!context.combiners)
    return raise(context, GL_INVALID_OPERATION, "a list's command of NV_register_combiners");
  for (std::size_t at = 0; at + sizeof(CombinerCommand) <= bytes.size();
       at += sizeof(CombinerCommand)) {
    CombinerCommand command;
    std::memcpy(&command, bytes.data() + at, sizeof command);
    executeCombinerCommand(context, command);
  }
}

} // namespace arbiter::state
