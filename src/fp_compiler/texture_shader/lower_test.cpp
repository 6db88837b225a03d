#include "fp_compiler/texture_shader/lower.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "fp_compiler/emit.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/evaluate_environments.h"
#include "fp_compiler/testing/random_texture_shaders.h"
#include "fp_compiler/texture_shader/operations.h"

namespace arbiter::fp::texture_shader {
namespace {

constexpr double kTolerance = 1.0 / 1024; ///< for a colour
constexpr double kUndetermined = 2e-3;    ///< smaller margins come from quotients near infinity

/// Returns the texel of a smooth texture: near coordinates have near texels.
Color texelAt(const Texture &texture, int unit, const std::array<double, 3> &at) {
  Color color;
  for (std::size_t c = 0; c < 4; ++c) {
    const double phase = at[0] * 0.7 + at[1] * 1.1 + at[2] * 0.5 + double(c) * 1.3 + unit;
    const bool isSigned = texture.signs == Signs::Signed ||
                          (texture.signs == Signs::SignedRgb && c < 3) ||
                          (texture.base >= Base::Dsdt && c < 2);
    color[c] = isSigned ? std::sin(phase) : 0.5 + 0.5 * std::sin(phase);
  }
  switch (texture.base) {
  case Base::Alpha:
    return {0, 0, 0, color[3]};
  case Base::Luminance:
    return {color[0], color[0], color[0], 1};
  case Base::LuminanceAlpha:
    return {color[0], color[0], color[0], color[3]};
  case Base::Intensity:
    return {color[0], color[0], color[0], color[0]};
  case Base::Rgb:
    color[3] = 1;
    return color;
  default:
    return color;
  }
}

struct Fragment {
  State state;
  Inputs inputs;
  Color primary{};
  std::array<Color, kUnits> constants{};

  explicit Fragment(std::uint64_t seed) {
    testing::Random random(seed);
    state = testing::randomTextureShaders(random, 1 + random.below(kUnits));
    const auto wide = [&] { return double(random.real(-2.0f, 2.0f)); };
    for (std::size_t unit = 0; unit < kUnits; ++unit) {
      for (double &c : inputs.coordinates[unit])
        c = wide();
      inputs.coordinates[unit][3] = random.chance(50) ? 1.0 : 2.0;
      for (double &c : inputs.matrices[unit])
        c = wide();
      for (double &c : inputs.eyes[unit])
        c = wide();
      inputs.scales[unit] = wide();
      inputs.biases[unit] = wide();
      for (double &c : constants[unit])
        c = double(random.real(0.0f, 1.0f));
    }
    for (double &c : primary)
      c = double(random.real(0.0f, 1.0f));
    inputs.near = 0.25;
    inputs.far = 0.75;
    inputs.sample = [this](int unit, const std::array<double, 3> &at) {
      return Sampled{texelAt(state.textures[std::size_t(unit)], unit, at), 1.0};
    };
  }

  [[nodiscard]] ir::Evaluation run(const ir::Program &program) const {
    const auto single = [](const Color &v) {
      return ir::Vec4{float(v[0]), float(v[1]), float(v[2]), float(v[3])};
    };
    std::vector<ir::Vec4> attributes;
    for (const ir::Attribute &attribute : program.attributes)
      attributes.push_back(attribute.kind == ir::AttributeKind::TexCoord
                               ? single(inputs.coordinates[attribute.index])
                               : single(primary));
    ir::Inputs given;
    given.attributes = attributes;
    given.parameter = [&](const ir::Parameter &row) -> ir::Vec4 {
      if (row.kind == ir::ParameterKind::State)
        return row.state.item == ir::StateItem::DepthRange
                   ? ir::Vec4{float(inputs.near), float(inputs.far), 0.5f, 1}
                   : single(constants[row.state.index]);
      const auto at = std::size_t(row.index - parameter(0, Row::Matrix));
      const std::size_t unit = at / 3;
      if (at % 3 == std::size_t(Row::Matrix))
        return single(inputs.matrices[unit]);
      if (at % 3 == std::size_t(Row::ScaleBias))
        return {float(inputs.scales[unit]), float(inputs.biases[unit]), 0, 0};
      const auto &eye = inputs.eyes[unit];
      return {float(eye[0]), float(eye[1]), float(eye[2]), 0};
    };
    given.texture = [&](const ir::Sample &sample) {
      const auto &c = sample.coordinate;
      std::array<double, 3> at = {double(c[0]), double(c[1]), double(c[2])};
      if (sample.target == ir::TexTarget::Tex1D)
        at[1] = at[2] = 0;
      if (sample.target == ir::TexTarget::Tex2D || sample.target == ir::TexTarget::Rect)
        at[2] = 0;
      return single(texelAt(state.textures[sample.unit], sample.unit, at));
    };
    return ir::evaluate(program, given);
  }
};

/// Drops the coordinates that flat targets ignore, so that the oracle ignores them too.
void flatten(Fragment &fragment) {
  fragment.inputs.sample = [&fragment](int unit, const std::array<double, 3> &at) {
    std::array<double, 3> flat = at;
    const auto target = *infoOf(fragment.state.stages[std::size_t(unit)].operation).target;
    if (target == ir::TexTarget::Tex1D)
      flat[1] = flat[2] = 0;
    if (target == ir::TexTarget::Tex2D || target == ir::TexTarget::Rect)
      flat[2] = 0;
    return Sampled{texelAt(fragment.state.textures[std::size_t(unit)], unit, flat), 1.0};
  };
}

void compare(const ir::Program &program, const Fragment &fragment, const Evaluated &expected,
             const Color &color) {
  ASSERT_TRUE(ir::validate(program).empty()) << ir::validate(program).front();
  const ir::Evaluation got = fragment.run(program);
  ASSERT_EQ(got.killed, expected.discarded) << ir::print(program);
  if (got.killed)
    return;
  for (std::size_t c = 0; c < 4; ++c)
    ASSERT_NEAR(double(got.outputs[0][c]), color[c], kTolerance) << "component " << c << '\n'
                                                                 << ir::print(program);
  ASSERT_EQ(got.depth.has_value(), expected.replacesDepth);
  if (got.depth) {
    ASSERT_NEAR(double(*got.depth), expected.depth, 1e-3) << ir::print(program);
  }
}

TEST(TextureShaders, RandomStatesAreWhatTheSpecificationSays) {
  int undetermined = 0, depths = 0, discards = 0;
  std::array<int, kOperations> consistent{}, inconsistent{};
  for (std::uint64_t seed = 0; seed < 12000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Fragment fragment(seed);
    flatten(fragment);
    const Evaluated expected = evaluate(fragment.state, fragment.inputs);
    const std::uint32_t rules = consistentStages(fragment.state);
    for (int unit = 0; unit < fragment.state.units; ++unit) {
      const auto operation = fragment.state.stages[std::size_t(unit)].operation;
      ASSERT_EQ((rules >> unit & 1u) != 0, expected.consistent[std::size_t(unit)])
          << "unit " << unit << ", operation " << int(operation);
      ++(expected.consistent[std::size_t(unit)] ? consistent
                                                : inconsistent)[std::size_t(operation)];
    }
    if (expected.margin < kUndetermined) {
      ++undetermined;
      continue;
    }
    depths += expected.replacesDepth && !expected.discarded ? 1 : 0;
    discards += expected.discarded ? 1 : 0;
    testing::Random random(seed);
    Key key;
    key.shaders = fragment.state;
    key.environments = testing::randomEnvironments(random, fragment.state.units);
    const Color color = evaluateEnvironments(key.environments, expected.environment,
                                             expected.colors, fragment.constants, fragment.primary);
    ir::Program program = lower(essential(key));
    compare(program, fragment, expected, color);
    if (HasFatalFailure())
      return;
    optimise(program);
    compare(program, fragment, expected, color);
    if (HasFatalFailure())
      return;
  }
  EXPECT_LT(undetermined, 1200);
  EXPECT_GT(depths, 20);
  EXPECT_GT(discards, 100);
  for (int operation = 1; operation < kOperations; ++operation) {
    EXPECT_GT(consistent[std::size_t(operation)], 10) << operation;
    if (readsPrevious(infoOf(Operation(operation)).family)) {
      EXPECT_GT(inconsistent[std::size_t(operation)], 3) << operation;
    }
  }
}

TEST(TextureShaders, StatesThatDrawAlikeAreOne) {
  Key one, other;
  one.shaders.stages[0].operation = other.shaders.stages[0].operation = Operation::Texture2D;
  EXPECT_TRUE(essential(one) == essential(other)) << "no texture: NONE";
  other.shaders.textures[0] = {Base::Rgba, Signs::Unsigned, false};
  EXPECT_FALSE(essential(one) == essential(other));
  one.shaders.textures[0] = other.shaders.textures[0];
  other.shaders.stages[0].mapping = Mapping::ExpandNormal;
  other.shaders.stages[3] = {Operation::DotProduct, 0, 5, Mapping::ExpandNormal};
  one.shaders.stages[3] = {Operation::DotProduct, 0, 0, Mapping::ExpandNormal};
  EXPECT_TRUE(essential(one) == essential(other));
}

TEST(TextureShaders, GoBeforeCombinersToo) {
  Key key;
  key.combines = true;
  key.shaders.stages[0].operation = Operation::PassThrough;
  key.combiners.finals[3] = {combiners::Register::Texture0, combiners::Mapping::UnsignedIdentity,
                             combiners::Usage::Rgb};
  for (std::size_t v = 0; v < 3; ++v)
    key.combiners.finals[v] = {};
  key.combiners.stages[0].rgb.sum = key.combiners.stages[0].alpha.sum =
      combiners::Register::Discard;
  Fragment fragment(1);
  fragment.inputs.coordinates[0] = {0.25, 2.0, -1.0, 0.5};
  const ir::Evaluation got = fragment.run(lower(essential(key)));
  EXPECT_NEAR(got.outputs[0][0], 0.25f, 1e-6f);
  EXPECT_NEAR(got.outputs[0][1], 1.0f, 1e-6f);
  EXPECT_NEAR(got.outputs[0][2], 0.0f, 1e-6f);
  EXPECT_NEAR(got.outputs[0][3], 0.5f, 1e-6f) << "spare0's alpha";
  Key nine = key;
  nine.fx9 = true;
  EXPECT_FALSE(essential(key) == essential(nine));
  const ir::Evaluation rounded = fragment.run(lower(essential(nine)));
  EXPECT_NEAR(rounded.outputs[0][0], 64.0f / 255.0f, 1e-6f) << "63.75";
  EXPECT_NEAR(rounded.outputs[0][3], 128.0f / 255.0f, 1e-6f) << "127.5";
}

} // namespace
} // namespace arbiter::fp::texture_shader
