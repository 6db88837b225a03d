#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/validate.h"

/// Tests Numerics::Fp24 outside the opcodes: registers, textures, KIL and the options.
/// tests/fp24_vs_integers tests the opcodes.
namespace arbiter::fp::ir {
namespace {

constexpr float kFine = 0x1.00001p0f; ///< 1 + 2^-20: a single, which becomes 1 in 24 bits
constexpr float kMax = 0x1.0001FEp0f; ///< truncated it is 1 + 2^-16, rounded 1 + 2^-15
constexpr float kDown = 0x1.0001p0f;  ///< 1 + 2^-16
constexpr float kUp = 0x1.0002p0f;    ///< 1 + 2^-15

Vec4 run(const Builder &b, Numerics numerics, Inputs inputs = {}) {
  EXPECT_TRUE(validate(b.program()).empty());
  inputs.numerics = numerics;
  return evaluate(b.program(), inputs).outputs.at(0);
}

TEST(Fp24, RegistersAreReadEachInItsWay) {
  const Vec4 given = {kMax, -kMax, 0x1p-63f, 0x1p70f};
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Vec4 attributes[] = {given};
  Inputs inputs;
  inputs.attributes = attributes;
  inputs.parameter = [&](const Parameter &) { return given; };
  const auto read = [&](const std::function<Source(Builder &)> &source) {
    Builder b;
    b.op(Opcode::Mov, b.color(), {source(b)});
    EXPECT_EQ(run(b, Numerics::Host, inputs)[1], given[1]);
    return run(b, Numerics::Fp24, inputs);
  };
  const Vec4 rounded = {kUp, -kUp, 0, kInfinity};
  const Vec4 truncated = {kDown, -kDown, 0, fp24::kGreatest};
  EXPECT_EQ(read([](Builder &b) { return b.attribute(AttributeKind::TexCoord); }), rounded);
  EXPECT_EQ(read([](Builder &b) { return b.attribute(AttributeKind::Position); }), rounded);
  EXPECT_EQ(read([](Builder &b) { return b.attribute(AttributeKind::FogCoord); }), rounded);
  EXPECT_EQ(read([](Builder &b) { return b.local(0); }), truncated);
  EXPECT_EQ(read([](Builder &b) { return b.env(0); }), truncated);
  EXPECT_EQ(read([](Builder &b) { return b.state({StateItem::FogColor}); }), truncated);
  EXPECT_EQ(read([&](Builder &b) { return b.constant(given[0], given[1], given[2], given[3]); }),
            truncated);
}

TEST(Fp24, ColorsHaveTwelveBits) {
  for (const AttributeKind kind : {AttributeKind::ColorPrimary, AttributeKind::ColorSecondary}) {
    Builder b;
    b.op(Opcode::Mov, b.color(), {b.attribute(kind)});
    const Vec4 attributes[] = {{0.5f, -3, 7, 1.4f / 4095}};
    Inputs inputs;
    inputs.attributes = attributes;
    // 2047.5 rounds to the even 2048, and 1.4 to 1.
    EXPECT_EQ(run(b, Numerics::Fp24, inputs),
              (Vec4{fp24::rounded(2048.0f / 4095), 0, 1, fp24::rounded(1.0f / 4095)}));
    EXPECT_EQ(run(b, Numerics::Legacy, inputs), attributes[0]);
  }
}

TEST(Fp24, TexturesDivideInSinglesAndTexelsAreRounded) {
  Builder b;
  const auto coordinate = b.attribute(AttributeKind::TexCoord);
  b.tex(Opcode::Txp, b.color().mask("xy"), coordinate, 0, TexTarget::Tex2D);
  b.tex(Opcode::Txb, b.color().mask("zw"), coordinate, 0, TexTarget::Tex2D);
  const Vec4 attributes[] = {{kFine, 2, 0, 3 * kFine}};
  std::vector<Sample> seen;
  Inputs inputs;
  inputs.attributes = attributes;
  inputs.texture = [&](const Sample &s) {
    seen.push_back(s);
    return Vec4{kFine, kMax, kMax, -kMax};
  };
  EXPECT_EQ(run(b, Numerics::Fp24, inputs), (Vec4{1, kUp, kUp, -kUp}));
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0].coordinate, (Vec4{1.0f / 3.0f, 2.0f / 3.0f, 0, 0}));
  EXPECT_EQ(seen[1].coordinate, (Vec4{1, 2, 0, 0}));
  EXPECT_EQ(seen[1].bias, 3.0f);
}

TEST(Fp24, KilSeesTheRegister) {
  for (const float value : {-0x1p-63f, -0x1p-62f}) {
    Builder b;
    b.op(Opcode::Mov, b.color(), {b.constant(1)});
    b.kil(b.constant(value));
    Inputs inputs;
    EXPECT_TRUE(evaluate(b.program(), inputs).killed);
    inputs.numerics = Numerics::Fp24;
    EXPECT_EQ(evaluate(b.program(), inputs).killed, value == -0x1p-62f);
  }
}

TEST(Fp24, EveryStepIsRounded) {
  Builder b;
  // 2^17 + 1 rounds to 2^17, twice. In single precision 2 remain.
  b.op(Opcode::Dp4, b.color(), {b.constant(0x1p17f, 1, 1, -0x1p17f), b.constant(1)});
  EXPECT_EQ(run(b, Numerics::Fp24)[0], 0.0f);
  EXPECT_EQ(run(b, Numerics::Legacy)[0], 2.0f);
}

TEST(Fp24, AVertexProgramsArithmeticIsLegacys) {
  Builder b(Language::ArbVertex);
  const auto infinity = b.temporary();
  b.op(Opcode::Rcp, infinity, {b.constant(0).swz("x")});
  b.op(Opcode::Mad, b.result(OutputKind::Position),
       {infinity.read(), b.constant(0), b.constant(kFine)});
  EXPECT_EQ(run(b, Numerics::Fp24), (Vec4{kFine, kFine, kFine, kFine}));
  EXPECT_TRUE(std::isnan(run(b, Numerics::Host)[0]));
}

/// Returns the red of a colour after fog.
float fogged(FogMode mode, float c, Vec4 params, Numerics numerics) {
  Builder b;
  b.options().fog = mode;
  b.op(Opcode::Mov, b.color(), {b.constant(0.75f, 2, -1, kFine)});
  Inputs inputs;
  inputs.fogCoordinate = c;
  inputs.parameter = [&](const Parameter &p) {
    return p.state.item == StateItem::FogParams ? params : Vec4{kMax, kMax, kMax, 0};
  };
  const Vec4 color = run(b, numerics, inputs);
  EXPECT_EQ(color[3], 1.0f) << "clamped, not fogged";
  return color[0];
}

float blended(float factor) {
  using fp24::rounded;
  return rounded(rounded(factor * 0.75f) + rounded(rounded(1 - factor) * kDown));
}

TEST(Fp24, FogIsTheInstructionsThatItCosts) {
  using fp24::rounded, fp24::truncated;
  const float c = 0.7f, d = 0.3f, end = 2.5f, scale = 1 / (2.5f - 0.25f);
  const Vec4 params = {d, 0.25f, end, scale};
  const float exp = rounded(rounded(c) * truncated(d * 1.442695041f));
  EXPECT_EQ(fogged(FogMode::Exp, c, params, Numerics::Fp24),
            blended(rounded(float(std::exp2(-double(exp))))));
  const float root = rounded(rounded(c) * truncated(d * 1.201122409f));
  EXPECT_EQ(fogged(FogMode::Exp2, c, params, Numerics::Fp24),
            blended(rounded(float(std::exp2(-double(rounded(root * root)))))));
  EXPECT_EQ(fogged(FogMode::Linear, c, params, Numerics::Fp24),
            blended(rounded(rounded(rounded(c) * truncated(-scale)) + truncated(end * scale))));
  for (const FogMode mode : {FogMode::Exp, FogMode::Exp2, FogMode::Linear}) {
    const float fine = fogged(mode, c, params, Numerics::Host);
    EXPECT_NE(fogged(mode, c, params, Numerics::Fp24), fine);
    EXPECT_NEAR(fogged(mode, c, params, Numerics::Fp24), fine, 1e-4);
    EXPECT_EQ(fogged(mode, c, params, Numerics::Legacy), fine);
  }
}

TEST(Fp24, ColorSumTakesTheTwelveBits) {
  Builder b(Language::AtiFragment);
  b.options().colorSum = true;
  b.op(Opcode::Mov, b.color(), {b.constant(0.25f)});
  Inputs inputs;
  inputs.secondary = {0.5f, kFine, -1, 1};
  EXPECT_EQ(run(b, Numerics::Fp24, inputs),
            (Vec4{fp24::rounded(0.25f + fp24::rounded(2048.0f / 4095)), 1.25f, 0.25f, 0.25f}));
  EXPECT_EQ(run(b, Numerics::Host, inputs), (Vec4{0.75f, 0.25f + kFine, -0.75f, 0.25f}));
}

} // namespace
} // namespace arbiter::fp::ir
