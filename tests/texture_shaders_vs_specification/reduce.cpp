#include "reduce.h"

#include <cstdio>
#include <iterator>

namespace shaded {

using namespace arbiter::fp::texture_shader;

namespace {

template <typename T> bool becomes(T &value, const T &simple) {
  const bool changes = !(value == simple);
  value = simple;
  return changes;
}

/// True for COMBINE4_NV: the functions of both halves have four arguments.
bool hasFour(const Environment &environment) {
  return argumentsOf(environment.color.function) == 4;
}

bool withoutEnvironment(Kept &kept, std::size_t unit) {
  return becomes(kept.environments[unit].mode, EnvironmentMode::None);
}

bool withoutStage(Kept &kept, std::size_t unit) {
  return becomes(kept.state.stages[unit].operation, Operation::None);
}

bool replaces(Kept &kept, std::size_t unit) {
  return kept.environments[unit].mode == EnvironmentMode::Combine &&
         becomes(kept.environments[unit].mode, EnvironmentMode::Replace);
}

bool withoutFour(Kept &kept, std::size_t unit) {
  Environment &environment = kept.environments[unit];
  if (environment.mode != EnvironmentMode::Combine || !hasFour(environment))
    return false;
  environment.color.function = environment.alpha.function = CombineFunction::Modulate;
  return true;
}

/// Simplifies the function of COMBINE_RGB or of COMBINE_ALPHA.
template <bool kAlpha> bool simpleFunction(Kept &kept, std::size_t unit) {
  Environment &environment = kept.environments[unit];
  if (environment.mode != EnvironmentMode::Combine)
    return false;
  CombineHalf &half = kAlpha ? environment.alpha : environment.color;
  const bool scaled = becomes(half.scale, std::uint8_t(1));
  return (!hasFour(environment) && becomes(half.function, CombineFunction::Replace)) || scaled;
}

/// Replaces an argument by the unmodified primary color.
template <bool kAlpha, int kArgument> bool simpleArgument(Kept &kept, std::size_t unit) {
  Environment &environment = kept.environments[unit];
  if (environment.mode != EnvironmentMode::Combine)
    return false;
  CombineHalf &half = kAlpha ? environment.alpha : environment.color;
  return becomes(half.arguments[kArgument], {CombineSource::Primary, kAlpha, false});
}

using Simplify = bool (*)(Kept &kept, std::size_t unit);
constexpr Simplify kSimplify[] = {
    withoutEnvironment,
    withoutStage,
    withoutFour,
    replaces,
    simpleFunction<false>,
    simpleFunction<true>,
    simpleArgument<false, 0>,
    simpleArgument<false, 1>,
    simpleArgument<false, 2>,
    simpleArgument<false, 3>,
    simpleArgument<true, 0>,
    simpleArgument<true, 1>,
    simpleArgument<true, 2>,
    simpleArgument<true, 3>,
};

void print(const CombineHalf &half) {
  std::printf(" [function %d x%d:", int(half.function), int(half.scale));
  for (int i = 0; i < argumentsOf(half.function); ++i) {
    const CombineArgument &argument = half.arguments[std::size_t(i)];
    std::printf(" %s%d%s", argument.complement ? "1-" : "", int(argument.source),
                argument.alpha ? "a" : "c");
  }
  std::printf("]");
}

} // namespace

int partsOf(const State &state) { return int(std::size(kSimplify)) * state.units; }

bool simplify(Kept &kept, int part) {
  const int units = kept.state.units;
  return kSimplify[part / units](kept, std::size_t(part % units));
}

void describe(const Kept &kept, bool withEnvironments, const Evaluated &evaluated) {
  const State &state = kept.state;
  for (std::size_t unit = 0; unit < state.units; ++unit) {
    const Stage &stage = state.stages[unit];
    const Texture &texture = state.textures[unit];
    const Color &color = evaluated.colors[unit];
    std::printf("    unit %zu:%s operation %d%s of unit %d, mapping %d, texture (%d,%d), gives "
                "(%.4f %.4f %.4f %.4f) as %d",
                unit, state.conventional ? " conventional" : "", int(stage.operation),
                evaluated.consistent[unit] ? "" : "!", int(stage.previous), int(stage.mapping),
                int(texture.base), int(texture.signs), color[0], color[1], color[2], color[3],
                int(evaluated.environment[unit]));
    const Environment &environment = kept.environments[unit];
    if (withEnvironments)
      std::printf("; environment %d", int(environment.mode));
    if (withEnvironments && environment.mode == EnvironmentMode::Combine) {
      print(environment.color);
      print(environment.alpha);
    }
    std::printf("\n");
  }
}

} // namespace shaded
