#include "fp_compiler/testing/random_texture_shaders.h"

#include "fp_compiler/texture_shader/operations.h"

namespace arbiter::fp::testing {

using namespace texture_shader;

namespace {

bool allowed(Operation operation, int unit, int units) {
  const bool notLast =
      operation == Operation::DotProduct || operation == Operation::DotProductDiffuseCubeMap;
  return infoOf(operation).firstUnit <= unit && !(notLast && unit == units - 1);
}

/// Sets a stage and its texture at random, whatever the other stages are.
void anyStage(Random &random, State &state, int unit) {
  Stage &stage = state.stages[std::size_t(unit)];
  do
    stage.operation = Operation(random.below(kOperations));
  while (!allowed(stage.operation, unit, state.units));
  stage.previous = std::uint8_t(unit > 0 ? random.below(unit) : 0);
  stage.cullLess = std::uint8_t(random.chance(60) ? 0 : random.below(16));
  stage.mapping = Mapping(random.below(3));
  state.textures[std::size_t(unit)] = randomTexture(random);
}

} // namespace

Texture randomTexture(Random &random) {
  Texture texture;
  texture.base = Base(random.chance(4) ? 0 : 1 + random.below(10));
  if (random.chance(40))
    texture.base = Base::Rgba;
  if (isRgba(texture.base) && random.chance(35))
    texture.signs = Signs::Signed;
  if (texture.base == Base::Hilo && random.chance(50))
    texture.signs = Signs::Signed;
  if (texture.base == Base::Rgba && random.chance(10))
    texture.signs = Signs::SignedRgb;
  if (texture.base >= Base::Dsdt)
    texture.signs = Signs::Signed;
  return texture;
}

State randomTextureShaders(Random &random, int units) {
  State state;
  state.units = std::uint8_t(units);
  for (int unit = 0; unit < units; ++unit) {
    // Tries until the stage is consistent and usually not a plain access. Runs of dot products
    // would be rare, so they are made on purpose.
    const bool wantsDots = unit > 0 && unit + 1 < units && random.chance(35);
    for (int attempt = 0; attempt < 40; ++attempt) {
      anyStage(random, state, unit);
      Operation &operation = state.stages[std::size_t(unit)].operation;
      const bool behindDot =
          unit > 0 &&
          (state.stages[std::size_t(unit) - 1].operation == Operation::DotProduct ||
           state.stages[std::size_t(unit) - 1].operation == Operation::DotProductDiffuseCubeMap);
      if (wantsDots && attempt < 20)
        operation = Operation::DotProduct;
      else if (behindDot && attempt < 30 && infoOf(operation).dots < 2)
        continue;
      if (operation == Operation::DotProductDiffuseCubeMap || random.chance(6))
        break;
      if ((consistentStages(state) >> unit & 1u) != 0 && operation != Operation::None)
        break;
    }
  }
  return state;
}

namespace {

CombineHalf randomHalf(Random &random, int units, bool alpha) {
  CombineHalf half;
  half.function = CombineFunction(random.below(13));
  if (alpha &&
      (half.function == CombineFunction::Dot3Rgb || half.function == CombineFunction::Dot3Rgba))
    half.function = CombineFunction::Modulate;
  half.scale = std::uint8_t(1 << random.below(3));
  for (CombineArgument &argument : half.arguments) {
    argument.source = CombineSource(random.below(int(CombineSource::Unit0) + units));
    argument.alpha = alpha || random.chance(30);
    argument.complement = random.chance(30);
  }
  return half;
}

} // namespace

Environments randomEnvironments(Random &random, int units) {
  Environments environments;
  for (int unit = 0; unit < units; ++unit) {
    Environment &environment = environments[std::size_t(unit)];
    environment.mode = EnvironmentMode(random.below(7));
    if (environment.mode != EnvironmentMode::Combine)
      continue;
    environment.color = randomHalf(random, units, false);
    environment.alpha = randomHalf(random, units, true);
    // COMBINE4_NV's functions need a mode of their own, so both halves use them or neither does.
    const auto four = [](const CombineHalf &half) { return argumentsOf(half.function) == 4; };
    if (four(environment.color) != four(environment.alpha))
      environment.alpha.function =
          four(environment.color) ? CombineFunction::AddProducts : CombineFunction::Modulate;
  }
  return environments;
}

} // namespace arbiter::fp::testing
