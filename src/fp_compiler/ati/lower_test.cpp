#include "fp_compiler/ati/lower.h"

#include <cmath>
#include <gtest/gtest.h>

#include "fp_compiler/ati/evaluate.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_ati.h"

namespace arbiter::fp::ati {
namespace {

/// A synthetic fragment, in the form of either interpreter.
struct Fragment {
  Inputs inputs;
  std::array<ir::Vec4, kConstants> env;
  std::array<ir::Vec4, kConstants> local;

  explicit Fragment(std::uint64_t seed) {
    testing::Random random(seed);
    const auto fill = [&](ir::Vec4 &value, float low, float high) {
      for (float &c : value)
        c = random.real(low, high);
    };
    for (ir::Vec4 &value : inputs.texCoords)
      fill(value, -2.0f, 2.0f);
    fill(inputs.primary, 0.0f, 1.0f);
    fill(inputs.secondary, 0.0f, 1.0f);
    for (ir::Vec4 &value : env)
      fill(value, -0.5f, 1.5f);
    for (ir::Vec4 &value : local)
      fill(value, -0.5f, 1.5f);
    inputs.constant = [this](const Constant &constant) {
      return (constant.kind == ConstantKind::Env ? env : local)[constant.index];
    };
    inputs.texture = texel;
  }
  Fragment(const Fragment &) = delete;
  Fragment &operator=(const Fragment &) = delete;

  static ir::Vec4 texel(int unit, const ir::Vec4 &c) {
    const float mix = c[0] + 3 * c[1] + 7 * c[2] + float(unit);
    const float wave = std::isfinite(mix) ? std::sin(mix) : 0.0f;
    return {wave, wave * wave, -wave, 1 - wave};
  }

  [[nodiscard]] ir::Vec4 run(const ir::Program &program) const {
    std::vector<ir::Vec4> attributes;
    for (const ir::Attribute &attribute : program.attributes)
      attributes.push_back(attribute.kind == ir::AttributeKind::TexCoord
                               ? inputs.texCoords[attribute.index]
                           : attribute.kind == ir::AttributeKind::ColorPrimary ? inputs.primary
                                                                               : inputs.secondary);
    ir::Inputs irInputs;
    irInputs.attributes = attributes;
    irInputs.parameter = [this](const ir::Parameter &row) {
      return (row.kind == ir::ParameterKind::Env ? env : local)[row.index];
    };
    irInputs.texture = [](const ir::Sample &s) { return texel(s.unit, s.coordinate); };
    return ir::evaluate(program, irInputs).outputs.at(0);
  }
};

/// Returns the lowered shader with textures that use all three coordinates.
ir::Program lowered(const Shader &shader, const LowerOptions &options) {
  ir::Program program = lower(shader, options);
  for (ir::Instruction &instruction : program.code)
    if (ir::info(instruction.op).has(ir::Texture))
      instruction.target = ir::TexTarget::Tex3D;
  return program;
}

bool same(const ir::Vec4 &a, const ir::Vec4 &b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (a[i] != b[i] && !(std::isnan(a[i]) && std::isnan(b[i])))
      return false;
  return true;
}

std::string text(const ir::Vec4 &v) {
  std::string all;
  for (const float c : v)
    all += std::to_string(c) + " ";
  return all;
}

void expectSame(const Shader &shader, const LowerOptions &options, const std::string &what) {
  const ir::Program program = lowered(shader, options);
  EXPECT_EQ(program.language, ir::Language::AtiFragment);
  for (const std::string &problem : ir::validate(program))
    ADD_FAILURE() << what << ": " << problem;
  ir::Program optimised = program;
  optimise(optimised);
  for (std::uint64_t i = 0; i < 4; ++i) {
    const Fragment fragment(i);
    const ir::Vec4 expected = evaluate(shader, fragment.inputs, options);
    const ir::Vec4 seen = fragment.run(program);
    EXPECT_TRUE(same(expected, seen))
        << what << ": " << text(seen) << "expected " << text(expected) << "\n"
        << ir::print(program);
    EXPECT_TRUE(same(expected, fragment.run(optimised))) << what << ", optimised\n"
                                                         << ir::print(optimised);
  }
}

TEST(Lower, RandomShadersMeanWhatTheSpecificationSays) {
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    testing::RandomAtiOptions options;
    options.separateDots = seed % 2 == 0;
    const Shader shader = testing::randomAtiShader(seed, options);
    expectSame(shader, {.registerRange = seed % 3 == 0 ? 8u : 0u}, "seed " + std::to_string(seed));
    if (HasFailure())
      return;
  }
}

/// Returns a shader that reads three components of t0, t1, t2 into r1, r2, r3 and sets their alpha.
Shader prepared() {
  Shader shader;
  shader.passCount = 1;
  Pass &pass = shader.passes[0];
  for (std::uint8_t i = 0; i < 3; ++i) {
    pass.setups[i + 1u] = {SetupKind::PassTexCoord, false, i, Coordinates::Str, {}};
    Operation alpha;
    alpha.destination = i + 1u;
    alpha.arguments[0] = {Source::Register, std::uint8_t(i + 1), Replicate::Blue};
    pass.pairs[i].alpha = alpha;
  }
  pass.pairCount = 4;
  return shader;
}

Operation reading(Op op) {
  Operation operation;
  operation.op = op;
  for (int i = 0; i < argumentCount(op); ++i)
    operation.arguments[std::size_t(i)] = {Source::Register, std::uint8_t(i + 1)};
  return operation;
}

/// Tests the operation alone and as both halves of a pair.
void expectPair(const Operation &operation, const std::string &what) {
  for (const bool whole : {false, true}) {
    Shader shader = prepared();
    shader.passes[0].pairs[3].color = operation;
    if (whole)
      shader.passes[0].pairs[3].alpha = operation;
    for (const std::uint32_t range : {0u, 8u})
      expectSame(shader, {range}, what);
  }
}

TEST(Lower, EveryOpWithEveryArgumentModifier) {
  for (int op = 0; op <= int(Op::Dot2Add); ++op)
    for (int at = 0; at < argumentCount(Op(op)); ++at)
      for (int modifiers = 0; modifiers < 16; ++modifiers)
        for (int replicate = 0; replicate <= 4; ++replicate) {
          Operation operation = reading(Op(op));
          Argument &argument = operation.arguments[std::size_t(at)];
          argument.replicate = Replicate(replicate);
          argument.complement = modifiers & 1;
          argument.bias = modifiers & 2;
          argument.twice = modifiers & 4;
          argument.negate = modifiers & 8;
          expectPair(operation, "op " + std::to_string(op) + " argument " + std::to_string(at) +
                                    " modifiers " + std::to_string(modifiers) + " replicate " +
                                    std::to_string(replicate));
        }
}

TEST(Lower, EveryOpWithEveryDestinationModifier) {
  for (int op = 0; op <= int(Op::Dot2Add); ++op)
    for (int scale = 0; scale <= int(Scale::Eighth); ++scale)
      for (const bool saturate : {false, true})
        for (std::uint8_t mask = 1; mask <= 7; ++mask) {
          Operation operation = reading(Op(op));
          operation.scale = Scale(scale);
          operation.saturate = saturate;
          operation.mask = mask;
          Shader shader = prepared();
          shader.passes[0].pairs[3].color = operation;
          expectSame(shader, {}, "op " + std::to_string(op) + " scale " + std::to_string(scale));
        }
}

// The numbers below are computed by hand, so that the two interpreters cannot share the same
// misreading.

ir::Vec4 resultOf(const Shader &shader, const ir::Vec4 &t0, const LowerOptions &options = {}) {
  Fragment fragment(0);
  fragment.inputs.texCoords[0] = t0;
  const ir::Vec4 expected = evaluate(shader, fragment.inputs, options);
  const ir::Vec4 seen = fragment.run(lowered(shader, options));
  EXPECT_TRUE(same(expected, seen)) << text(seen) << "expected " << text(expected);
  return seen;
}

/// Returns a shader with r0 = t0.str and one pair.
Shader single(const Pair &pair) {
  Shader shader;
  shader.passCount = 1;
  shader.passes[0].setups[0].kind = SetupKind::PassTexCoord;
  shader.passes[0].pairs[0] = pair;
  shader.passes[0].pairCount = 1;
  return shader;
}

TEST(Lower, ModifiersApplyInTheOrderOfTheSpecification) {
  Pair pair;
  pair.color = Operation();
  pair.color->arguments[0] = {Source::Register, 0, Replicate::None, true, true, true, true};
  // All modifiers together give -(2 * ((1 - s) - 0.5)).
  EXPECT_TRUE(same(resultOf(single(pair), {0.25f, 0.5f, 1.0f, 9.0f}), {-0.5f, 0.0f, 1.0f, 0.0f}));
}

TEST(Lower, AlphaReadsWhatWasThereBeforeTheColorWrite) {
  Pair pair;
  pair.color = Operation();
  pair.color->arguments[0] = {Source::One, 0};
  pair.alpha = Operation();
  pair.alpha->arguments[0] = {Source::Register, 0, Replicate::Red};
  EXPECT_TRUE(same(resultOf(single(pair), {0.25f, 0.5f, 0.75f, 0.0f}), {1.0f, 1.0f, 1.0f, 0.25f}));
  // The colour also reads the registers as they were before the alpha write.
  pair.color->arguments[0] = {Source::Register, 0, Replicate::Alpha};
  EXPECT_TRUE(same(resultOf(single(pair), {0.25f, 0.5f, 0.75f, 0.0f}), {0.0f, 0.0f, 0.0f, 0.25f}));
}

TEST(Lower, Dot2AddTakesTheThirdArgumentsBlue) {
  Pair pair;
  pair.color = Operation();
  pair.color->op = Op::Dot2Add;
  pair.color->arguments = {Argument{Source::Register, 0}, Argument{Source::Register, 0},
                           Argument{Source::Constant, 0}};
  Shader shader = single(pair);
  shader.constants[0] = {ConstantKind::Value, 0, {0.125f, 0.25f, 0.5f, 1.0f}};
  EXPECT_TRUE(same(resultOf(shader, {1.0f, 2.0f, 3.0f, 4.0f}), {5.5f, 5.5f, 5.5f, 0.0f}));
}

TEST(Lower, ConditionsAtTheirThresholds) {
  Pair pair;
  pair.color = Operation();
  pair.color->op = Op::Cnd;
  pair.color->arguments = {Argument{Source::One, 0}, Argument{Source::Zero, 0},
                           Argument{Source::Register, 0}};
  const float above = std::nextafter(0.5f, 1.0f);
  EXPECT_TRUE(same(resultOf(single(pair), {0.5f, above, -1.0f, 0.0f}), {0, 1, 0, 0}));
  pair.color->op = Op::Cnd0;
  EXPECT_TRUE(same(resultOf(single(pair), {0.0f, -0.0f, -1e-20f, 0.0f}), {1, 1, 0, 0}));
}

TEST(Lower, ADotOfAlphaIsTheColorsUnderItsOwnModifiers) {
  Pair pair;
  pair.color = Operation();
  pair.color->op = Op::Dot3;
  pair.color->mask = 1;
  pair.color->arguments = {Argument{Source::Register, 0}, Argument{Source::Register, 0},
                           Argument{}};
  pair.alpha = Operation();
  pair.alpha->op = Op::Dot3;
  pair.alpha->scale = Scale::Half;
  EXPECT_TRUE(same(resultOf(single(pair), {1.0f, 2.0f, 3.0f, 0.0f}), {14.0f, 2.0f, 3.0f, 7.0f}));
}

TEST(Lower, ScaleComesBeforeTheClamps) {
  Pair pair;
  pair.color = Operation();
  pair.color->scale = Scale::Eight;
  pair.color->arguments[0] = {Source::Register, 0};
  const ir::Vec4 t0 = {0.5f, 2.0f, -2.0f, 0.0f};
  EXPECT_TRUE(same(resultOf(single(pair), t0), {4.0f, 16.0f, -16.0f, 0.0f}));
  EXPECT_TRUE(same(resultOf(single(pair), t0, {8}), {4.0f, 8.0f, -8.0f, 0.0f}));
  pair.color->saturate = true;
  EXPECT_TRUE(same(resultOf(single(pair), t0, {8}), {1.0f, 1.0f, 0.0f, 0.0f}));
}

TEST(Lower, RegistersCrossPassesOnlyThroughSetups) {
  Shader shader;
  shader.passCount = 2;
  Pass &first = shader.passes[0];
  first.setups[0].kind = SetupKind::PassTexCoord;
  Operation move;
  move.arguments[0] = {Source::One, 0};
  for (std::uint8_t i = 0; i < 2; ++i) { // r0.a = r1.rgba = 1
    move.destination = i;
    first.pairs[i].alpha = move;
    if (i == 1)
      first.pairs[i].color = move;
  }
  first.pairCount = 2;
  Pass &second = shader.passes[1];
  // Both setups read the registers of the first pass, so that the registers are exchanged.
  second.setups[0] = {SetupKind::PassTexCoord, true, 1, Coordinates::Str, {}};
  second.setups[1] = {SetupKind::PassTexCoord, true, 0, Coordinates::Str, {}};
  const ir::Vec4 t0 = {0.25f, 0.5f, 0.75f, 9.0f};
  EXPECT_TRUE(same(resultOf(shader, t0), {1.0f, 1.0f, 1.0f, 0.0f}));
  move.destination = 0;
  move.arguments[0] = {Source::Register, 1};
  second.pairs[0] = {move, move, {}};
  second.pairCount = 1;
  EXPECT_TRUE(same(resultOf(shader, t0), {0.25f, 0.5f, 0.75f, 0.0f}));
  move.arguments[0] = {Source::Register, 2}; // r2 has no setup
  second.pairs[0] = {move, move, {}};
  EXPECT_TRUE(same(resultOf(shader, t0), {0.0f, 0.0f, 0.0f, 0.0f}));
}

TEST(Lower, ProjectionDividesByTheThirdComponentTaken) {
  Pair pair;
  Shader shader = single(pair);
  shader.passes[0].pairCount = 0;
  ati::Setup &setup = shader.passes[0].setups[0];
  const ir::Vec4 t0 = {1.0f, 3.0f, 4.0f, 8.0f};
  setup.coordinates = Coordinates::Stq;
  EXPECT_TRUE(same(resultOf(shader, t0), {1.0f, 3.0f, 8.0f, 0.0f}));
  setup.coordinates = Coordinates::StrDr;
  EXPECT_TRUE(same(resultOf(shader, t0), {0.25f, 0.75f, 0.25f, 0.0f}));
  setup.coordinates = Coordinates::StqDq;
  EXPECT_TRUE(same(resultOf(shader, t0), {0.125f, 0.375f, 0.125f, 0.0f}));
  setup.kind = SetupKind::SampleMap;
  EXPECT_TRUE(same(resultOf(shader, t0), Fragment::texel(0, {0.125f, 0.375f, 0.125f, 0.0f})));
}

TEST(Lower, ConstantsAreClampedWhereTheyAreRead) {
  Pair pair;
  pair.color = Operation();
  pair.color->arguments[0] = {Source::Constant, 3};
  Shader shader = single(pair);
  shader.constants[3] = {ConstantKind::Value, 0, {2.0f, -1.0f, 0.5f, 0.0f}};
  EXPECT_TRUE(same(resultOf(shader, {}), {1.0f, 0.0f, 0.5f, 0.0f}));
  shader.constants[3] = {ConstantKind::Env, 5, {}};
  EXPECT_EQ(lower(shader).parameters.at(0).index, 5);
  expectSame(shader, {}, "env");
}

TEST(Lower, ConstantsStayAsTheyAreWhereTheOptionsSaySo) {
  Pair pair;
  pair.color = Operation();
  pair.color->arguments[0] = {Source::Constant, 3};
  Shader shader = single(pair);
  shader.constants[3] = {ConstantKind::Value, 0, {2.0f, -1.0f, 0.5f, 0.0f}};
  const ir::Program program = lower(shader, {.clampConstants = false});
  EXPECT_TRUE(same(ir::evaluate(program, {}).outputs[0], {2.0f, -1.0f, 0.5f, 0.0f}));
}

TEST(Lower, NothingGivesBlack) { EXPECT_TRUE(same(resultOf(Shader(), {}), {0, 0, 0, 0})); }

} // namespace
} // namespace arbiter::fp::ati
