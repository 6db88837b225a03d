#include "fp_compiler/combiners/lower.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "fp_compiler/back/assembly/assembly.h"
#include "fp_compiler/emit.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/testing/evaluate_combiners.h"
#include "fp_compiler/testing/evaluate_combiners_fx9.h"
#include "fp_compiler/testing/random_combiners.h"

namespace arbiter::fp::combiners {
namespace {

constexpr double kTolerance = 1.0 / 2048; ///< for a colour
constexpr double kUndetermined = 1e-4;    ///< minimum distance of a mux from its threshold

ir::Vec4 single(const Color &v) { return {float(v[0]), float(v[1]), float(v[2]), float(v[3])}; }

/// A combiner state, the surrounding GL state, and one fragment.
struct Fragment {
  State state;
  Surroundings around;
  Inputs inputs;
  double fogDistance = 0.0;
  std::array<double, kTextures> depths{};

  explicit Fragment(std::uint64_t seed) {
    testing::Random random(seed);
    state = testing::randomCombiners(random);
    const auto color = [&] {
      Color value;
      for (double &c : value)
        c = double(random.real(0.0f, 1.0f));
      return value;
    };
    inputs.primary = color();
    inputs.secondary = color();
    inputs.fog = color();
    for (Color &constant : inputs.constants)
      constant = color();
    for (int unit = 0; unit < kTextures; ++unit)
      texture(random, unit, color());
    around.fog = ir::FogMode(random.below(4));
    fogDistance = double(random.real(0.0f, 2.0f));
    inputs.fogFactor = fogFactor();
  }

  void texture(testing::Random &random, int unit, const Color &color) {
    const auto at = std::size_t(unit);
    constexpr ir::TexTarget kShadows[] = {ir::TexTarget::Shadow1D, ir::TexTarget::Shadow2D,
                                          ir::TexTarget::ShadowRect};
    around.texels[at] = Texel(random.below(4));
    around.targets[at] = ir::TexTarget(random.below(5));
    depths[at] = color[0];
    switch (around.texels[at]) {
    case Texel::None:
      inputs.textures[at] = {};
      return;
    case Texel::Color:
      inputs.textures[at] = color;
      return;
    default:
      break;
    }
    if (random.chance(50)) {
      around.targets[at] = kShadows[random.below(3)];
      inputs.textures[at].fill(depths[at]);
    } else {
      around.targets[at] = ir::TexTarget::Tex2D;
      inputs.textures[at] = {0, 0, 0, depths[at]};
    }
  }

  static constexpr double kDensity = 0.7, kStart = 0.25, kEnd = 1.5;

  [[nodiscard]] double fogFactor() const {
    switch (around.fog) {
    case ir::FogMode::None:
      return 1.0;
    case ir::FogMode::Linear:
      return std::clamp((kEnd - fogDistance) / (kEnd - kStart), 0.0, 1.0);
    case ir::FogMode::Exp:
      return std::exp(-kDensity * fogDistance);
    case ir::FogMode::Exp2:
      return std::exp(-kDensity * fogDistance * kDensity * fogDistance);
    }
    return 1.0;
  }

  [[nodiscard]] ir::Vec4 attribute(const ir::Attribute &attribute) const {
    switch (attribute.kind) {
    case ir::AttributeKind::ColorPrimary:
      return single(inputs.primary);
    case ir::AttributeKind::ColorSecondary:
      return single(inputs.secondary);
    case ir::AttributeKind::FogCoord:
      return {float(fogDistance), 0, 0, 1};
    default:
      return {0.5f, 0.5f, 0.5f, 1.0f};
    }
  }

  [[nodiscard]] ir::Vec4 parameter(const ir::Parameter &parameter) const {
    if (parameter.kind != ir::ParameterKind::State)
      return single(inputs.constants[parameter.index]);
    if (parameter.state.item == ir::StateItem::FogColor)
      return single(inputs.fog);
    return {float(kDensity), float(kStart), float(kEnd), float(1.0 / (kEnd - kStart))};
  }

  [[nodiscard]] ir::Vec4 texel(const ir::Sample &sample) const {
    const auto depth = float(depths[sample.unit]);
    switch (around.texels[sample.unit]) {
    case Texel::Depth:
      return {depth, depth, depth, 1.0f};
    case Texel::DepthInAlpha:
      return {0.0f, 0.0f, 0.0f, depth};
    default:
      return single(inputs.textures[sample.unit]);
    }
  }

  [[nodiscard]] ir::Evaluation run(const ir::Program &program,
                                   Numerics numerics = Numerics::Host) const {
    std::vector<ir::Vec4> attributes;
    for (const ir::Attribute &row : program.attributes)
      attributes.push_back(attribute(row));
    ir::Inputs given;
    given.numerics = numerics;
    given.attributes = attributes;
    given.parameter = [this](const ir::Parameter &row) { return parameter(row); };
    given.texture = [this](const ir::Sample &sample) { return texel(sample); };
    return ir::evaluate(program, given);
  }
};

std::size_t countOf(const ir::Program &program, ir::Opcode opcode) {
  return std::size_t(std::count_if(program.code.begin(), program.code.end(),
                                   [&](const ir::Instruction &i) { return i.op == opcode; }));
}

TEST(Combiners, RandomStatesGiveWhatTheEquationsGive) {
  int judged = 0;
  for (std::uint64_t seed = 0; seed < 12000; ++seed) {
    const Fragment fragment(seed);
    const Evaluated expected = evaluate(fragment.state, fragment.inputs);
    if (expected.margin < kUndetermined)
      continue;
    ++judged;
    const ir::Program program = lower(essential(fragment.state), fragment.around);
    ASSERT_TRUE(ir::validate(program).empty()) << "seed " << seed << "\n" << ir::print(program);
    const ir::Evaluation result = fragment.run(program);
    for (std::size_t c = 0; c < 4; ++c)
      ASSERT_NEAR(double(result.outputs[0][c]), expected.color[c], kTolerance)
          << "seed " << seed << ", component " << c << "\n"
          << ir::print(program);
  }
  EXPECT_GT(judged, 11000);
}

/// Every step is exact. The lowered program and the evaluator therefore agree exactly, before and
/// after the passes.
TEST(Combiners, RandomStatesGiveTheIntegersOfNineBits) {
  int judged = 0;
  for (std::uint64_t seed = 0; seed < 12000; ++seed) {
    Fragment fragment(seed);
    fragment.around.fx9 = true;
    const Evaluated expected = evaluateFx9(fragment.state, fragment.inputs);
    if (expected.margin < 1e-3)
      continue;
    ++judged;
    ir::Program program = lower(essential(fragment.state), fragment.around);
    ASSERT_TRUE(ir::validate(program).empty()) << "seed " << seed << "\n" << ir::print(program);
    for (const bool optimised : {false, true}) {
      if (optimised)
        optimise(program, Numerics::Fx9);
      const ir::Evaluation result = fragment.run(program, Numerics::Fx9);
      for (std::size_t c = 0; c < 4; ++c)
        ASSERT_NEAR(double(result.outputs[0][c]), expected.color[c], 1e-6)
            << "seed " << seed << ", component " << c << (optimised ? ", optimised" : "") << "\n"
            << ir::print(program);
    }
  }
  EXPECT_GT(judged, 9000);
}

TEST(Combiners, WhatIsSampledIsAmongTheTexturesThatAreRead) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const Fragment fragment(seed);
    const std::uint32_t read = texturesRead(fragment.state);
    for (const ir::Instruction &instruction : lower(fragment.state, fragment.around).code)
      if (ir::info(instruction.op).has(ir::Texture)) {
        ASSERT_NE(read >> instruction.unit & 1u, 0u)
            << "seed " << seed << ", unit " << int(instruction.unit);
      }
  }
}

TEST(Combiners, TheInitialStateIsThePrimaryColorWithTheSecondarySummed) {
  State state;
  Surroundings around;
  Inputs inputs;
  inputs.primary = {0.5, 0.25, 0.125, 0.75};
  inputs.secondary = {0.25, 0.5, 1.0, 0.0};
  const Evaluated expected = evaluate(state, inputs);
  EXPECT_NEAR(expected.color[0], 0.75, 1e-6);
  EXPECT_NEAR(expected.color[2], 1.0, 1e-6);
  EXPECT_NEAR(expected.color[3], 0.75, 1e-6);
  EXPECT_EQ(texturesRead(state), 0u);
  const ir::Program program = lower(state, around);
  EXPECT_EQ(countOf(program, ir::Opcode::Txp), 0u);
}

/// The products AB and CD become one MAD, as in an ARB program of the same meaning.
TEST(Combiners, ASumOfProductsIsOneInstruction) {
  State state;
  Portion &rgb = state.stages[0].rgb;
  rgb.inputs[0] = {textureRegister(0), Mapping::SignedIdentity, Usage::Rgb};
  rgb.inputs[1] = {Register::Constant0, Mapping::SignedIdentity, Usage::Rgb};
  rgb.inputs[2] = {textureRegister(1), Mapping::SignedIdentity, Usage::Rgb};
  rgb.inputs[3] = {Register::Constant1, Mapping::SignedIdentity, Usage::Rgb};
  Surroundings around;
  around.texels[0] = around.texels[1] = Texel::Color;
  const ir::Program program = lower(state, around);
  EXPECT_EQ(countOf(program, ir::Opcode::Mad), 1u) << ir::print(program);
  EXPECT_EQ(countOf(program, ir::Opcode::Txp), 2u);
}

TEST(Combiners, ATextureOfAnUnreadRegisterIsNotSampled) {
  State state;
  state.stages[0].rgb.inputs[0].source = textureRegister(3);
  state.stages[0].rgb.sum = Register::Discard;
  Surroundings around;
  around.texels.fill(Texel::Color);
  EXPECT_EQ(countOf(lower(state, around), ir::Opcode::Txp), 0u);
  EXPECT_EQ(texturesRead(state) & 8u, 0u);
}

/// A dot product is clamped before it enters a sum, but scaled unclamped when it is output.
TEST(Combiners, DotProductsInSums) {
  State state;
  Portion &rgb = state.stages[0].rgb;
  for (Input &input : rgb.inputs)
    input = {Register::Zero, Mapping::UnsignedInvert, Usage::Rgb}; // one
  rgb.abDot = true;                                                // three
  rgb.cdDot = true;
  rgb.scale = Scale::ByOneHalf;
  rgb.ab = Register::Spare1;
  state.finals[0] = {Register::Zero, Mapping::UnsignedIdentity, Usage::Rgb};
  state.finals[2] = {Register::Spare0, Mapping::UnsignedIdentity, Usage::Rgb};
  const Evaluated expected = evaluate(state, {});
  EXPECT_NEAR(expected.color[0], 1.0, 1e-6); // (1 + 1) / 2
  state.stages[0].rgb.inputs[3] = {Register::Zero, Mapping::UnsignedIdentity, Usage::Rgb};
  EXPECT_NEAR(evaluate(state, {}).color[0], 0.5, 1e-6); // (1 + 0) / 2
  state.finals[2].source = Register::Spare1;
  EXPECT_NEAR(evaluate(state, {}).color[0], 1.0, 1e-6); // 3 / 2, clamped
}

TEST(Combiners, ARegisterThatIsReadUnsignedIsClampedOnce) {
  State state;
  Portion &rgb = state.stages[0].rgb;
  for (Input &input : rgb.inputs)
    input = {Register::Texture0, Mapping::ExpandNormal, Usage::Rgb};
  rgb.abDot = true;
  rgb.ab = Register::Spare1;
  state.finals[0] = {Register::Spare1, Mapping::UnsignedIdentity, Usage::Rgb};
  state.finals[1] = {Register::Zero, Mapping::UnsignedInvert, Usage::Rgb}; // one
  state.finals[2] = state.finals[3] = {Register::Zero, Mapping::UnsignedIdentity, Usage::Rgb};
  Surroundings around;
  around.texels[0] = Texel::Color;
  around.targets[0] = ir::TexTarget::Tex2D;
  ir::Program program = lower(state, around);
  opt::run(program);
  const auto count = [&](ir::Opcode opcode) {
    return std::count_if(program.code.begin(), program.code.end(),
                         [&](const ir::Instruction &each) { return each.op == opcode; });
  };
  EXPECT_EQ(count(ir::Opcode::Max), 3) << "the texture's, the register's, and of alpha";
  EXPECT_EQ(count(ir::Opcode::Min), 2);
  EXPECT_EQ(count(ir::Opcode::Lrp), 0);
}

TEST(Combiners, WhatIsNotReadMakesNoOtherProgram) {
  State state, other;
  other.stages[3].rgb.mux = true;
  other.finals[4].source = Register::Primary;
  EXPECT_FALSE(state == other);
  EXPECT_TRUE(essential(state) == essential(other));
  other.finals[3].source = Register::ETimesF;
  EXPECT_EQ(essential(other).finals[4].source, Register::Primary);
}

TEST(Combiners, EveryProgramIsTextToo) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Fragment fragment(seed);
    const ir::Program program = lower(fragment.state, fragment.around);
    EXPECT_NE(emitGlsl(program).text.find("void main"), std::string::npos);
    EXPECT_EQ(emitAssembly(program).rfind("!!ARBfp1.0", 0), 0u);
  }
}

} // namespace
} // namespace arbiter::fp::combiners
