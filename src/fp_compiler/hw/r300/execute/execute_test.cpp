#include "fp_compiler/hw/r300/execute/execute.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "fp_compiler/hw/r300/check/legality.h"
#include "fp_compiler/hw/r300/check/sample_code.h"

namespace arbiter::fp::hw::r300 {
namespace {

using namespace testing;
using ir::Vec4;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Runs one pair that reads three constants and writes colour 0.
class Bench {
public:
  Bench() {
    ir::Builder b;
    (void)b.color();
    (void)b.depth();
    b.op(ir::Opcode::Mov, b.color(), {b.constant(0)});
    program = b.take();
    code.nodes = {{0, 0, 0, 1}};
    code.pairs.resize(1);
    code.constants.resize(3);
    Pair &pair = code.pairs[0];
    pair.rgb.sources = pair.alpha.sources = {row(0), row(1), row(2)};
    for (std::uint8_t i = 0; i < 3; ++i) {
      pair.rgb.arguments[i] = {RgbSelect::Xyz, i};
      pair.alpha.arguments[i] = {AlphaSelect::W, i};
    }
    pair.rgb.outputMask = 7;
    pair.alpha.outputMask = 8;
    pair.rgb.origin = pair.alpha.origin = 0;
  }

  Vec4 run(RgbOp rgb, AlphaOp alpha, const Vec4 &a, const Vec4 &b = {}, const Vec4 &c = {}) {
    code.pairs[0].rgb.op = rgb;
    code.pairs[0].alpha.op = alpha;
    code.constants[0].value = a;
    code.constants[1].value = b;
    code.constants[2].value = c;
    for (const Fault &fault : faults(code, program))
      ADD_FAILURE() << fault.text;
    evaluation = execute(code, program, {});
    return evaluation.outputs[0];
  }

  Half<RgbOp, RgbArgument> &rgb() { return code.pairs[0].rgb; }
  Half<AlphaOp, AlphaArgument> &alpha() { return code.pairs[0].alpha; }

  ir::Program program;
  Code code;
  ir::Evaluation evaluation;
};

TEST(Execute, OperationsOfBothHalves) {
  const Vec4 a = {1, -2, 3, -4}, b = {0.5f, 0.25f, -2, 8}, c = {0, 0.75f, -1, 0.5f};
  Bench bench;
  EXPECT_EQ(bench.run(RgbOp::Mad, AlphaOp::Mad, a, b, c), (Vec4{0.5f, 0.25f, -7, -31.5f}));
  EXPECT_EQ(bench.run(RgbOp::Min, AlphaOp::Min, a, b), (Vec4{0.5f, -2, -2, -4}));
  EXPECT_EQ(bench.run(RgbOp::Max, AlphaOp::Max, a, b), (Vec4{1, 0.25f, 3, 8}));
  // CND chooses A above one half, but not at it. CMP chooses A from zero up.
  EXPECT_EQ(bench.run(RgbOp::Cnd, AlphaOp::Cnd, a, b, c), (Vec4{0.5f, -2, -2, 8}));
  EXPECT_EQ(bench.run(RgbOp::Cmp, AlphaOp::Cmp, a, b, c), (Vec4{1, -2, -2, -4}));
  EXPECT_EQ(bench.run(RgbOp::Frc, AlphaOp::Frc, {1.25f, -0.25f, 3, -1.5f}),
            (Vec4{0.25f, 0.75f, 0, 0.5f}));
  EXPECT_EQ(bench.run(RgbOp::Dp3, AlphaOp::Dp, a, b), (Vec4{-6, -6, -6, -6}));
  EXPECT_EQ(bench.run(RgbOp::Dp4, AlphaOp::Dp, a, b), (Vec4{-38, -38, -38, -38}));
  EXPECT_EQ(bench.run(RgbOp::Dp3, AlphaOp::Mad, a, b, c), (Vec4{-6, -6, -6, -31.5f}));
}

TEST(Execute, ScalarOperations) {
  Bench bench;
  EXPECT_EQ(bench.run(RgbOp::ReplAlpha, AlphaOp::Ex2, {0, 0, 0, 3}), (Vec4{8, 8, 8, 8}));
  EXPECT_EQ(bench.run(RgbOp::ReplAlpha, AlphaOp::Lg2, {0, 0, 0, 8}), (Vec4{3, 3, 3, 3}));
  EXPECT_EQ(bench.run(RgbOp::ReplAlpha, AlphaOp::Rcp, {0, 0, 0, -4})[0], -0.25f);
  EXPECT_EQ(bench.run(RgbOp::ReplAlpha, AlphaOp::Rsq, {0, 0, 0, -4})[2], 0.5f);
  EXPECT_EQ(bench.run(RgbOp::ReplAlpha, AlphaOp::Rcp, {0, 0, 0, 0})[1], kInfinity);
}

TEST(Execute, AProductWithZeroIsZero) {
  Bench bench;
  EXPECT_EQ(bench.run(RgbOp::Mad, AlphaOp::Mad, {0, 0, 0, 0}, {kInfinity, 1, 1, -kInfinity},
                      {1, 2, 3, 4}),
            (Vec4{1, 2, 3, 4}));
}

TEST(Execute, SelectsOfRgbArguments) {
  const Vec4 a = {1, 2, 3, 4};
  const std::pair<RgbSelect, Vec4> kSelects[] = {
      {RgbSelect::Xyz, {1, 2, 3}},           {RgbSelect::Xxx, {1, 1, 1}},
      {RgbSelect::Yyy, {2, 2, 2}},           {RgbSelect::Zzz, {3, 3, 3}},
      {RgbSelect::Www, {4, 4, 4}},           {RgbSelect::Yzx, {2, 3, 1}},
      {RgbSelect::Zxy, {3, 1, 2}},           {RgbSelect::Wzy, {4, 3, 2}},
      {RgbSelect::Zero, {0, 0, 0}},          {RgbSelect::One, {1, 1, 1}},
      {RgbSelect::Half, {0.5f, 0.5f, 0.5f}},
  };
  for (const auto &[select, expected] : kSelects) {
    Bench bench;
    bench.rgb().arguments[0].select = select;
    Vec4 seen = bench.run(RgbOp::Max, AlphaOp::Max, a, {-9, -9, -9, -9});
    seen[3] = 0;
    EXPECT_EQ(seen, expected) << int(select);
  }
}

TEST(Execute, SelectsOfAlphaArguments) {
  const Vec4 a = {1, 2, 3, 4};
  const std::pair<AlphaSelect, float> kSelects[] = {
      {AlphaSelect::X, 1},    {AlphaSelect::Y, 2},   {AlphaSelect::Z, 3},      {AlphaSelect::W, 4},
      {AlphaSelect::Zero, 0}, {AlphaSelect::One, 1}, {AlphaSelect::Half, 0.5f}};
  for (const auto &[select, expected] : kSelects) {
    Bench bench;
    bench.alpha().arguments[0].select = select;
    EXPECT_EQ(bench.run(RgbOp::Max, AlphaOp::Max, a, {-9, -9, -9, -9})[3], expected) << int(select);
  }
}

TEST(Execute, TheHalvesHaveAddressesOfTheirOwn) {
  Bench bench;
  bench.alpha().sources[0] = row(1);
  bench.rgb().arguments[0].select = RgbSelect::Wzy;   // w of c1, z and y of c0
  bench.alpha().arguments[0].select = AlphaSelect::Y; // y of the RGB half's c0
  bench.rgb().arguments[1] = {RgbSelect::Zero};
  bench.alpha().arguments[1] = {AlphaSelect::Zero};
  EXPECT_EQ(bench.run(RgbOp::Max, AlphaOp::Max, {1, 2, 3, 4}, {5, 6, 7, 8}), (Vec4{8, 3, 2, 2}));
}

TEST(Execute, SignsAfterAbs) {
  Bench bench;
  bench.rgb().arguments[0].absolute = bench.alpha().arguments[0].negate = true;
  bench.rgb().arguments[1].absolute = bench.rgb().arguments[1].negate = true;
  EXPECT_EQ(bench.run(RgbOp::Mad, AlphaOp::Mad, {-1, 2, -3, -4}, {-2, 2, 2, 2}),
            (Vec4{-2, -4, -6, 8}));
}

TEST(Execute, PresubtractIsEachHalfsOwn) {
  const Vec4 a = {0.25f, 2, -1, 4}, b = {1, 1, 1, 1};
  const std::pair<Presubtract, Vec4> kOperations[] = {
      {Presubtract::OneMinusTwoS0, {0.5f, -3, 3, -7}},
      {Presubtract::S1MinusS0, {0.75f, -1, 2, -3}},
      {Presubtract::S1PlusS0, {1.25f, 3, 0, 5}},
      {Presubtract::OneMinusS0, {0.75f, -1, 2, -3}},
  };
  for (const auto &[operation, expected] : kOperations) {
    Bench bench;
    bench.rgb().presubtract = bench.alpha().presubtract = operation;
    bench.rgb().arguments[0].source = bench.alpha().arguments[0].source = kPresubtracted;
    EXPECT_EQ(bench.run(RgbOp::Mad, AlphaOp::Mad, a, b), expected) << int(operation);
    // X of an alpha argument reads the RGB half's presubtract result.
    bench.alpha().presubtract = Presubtract::None;
    bench.alpha().arguments[0].select = AlphaSelect::X;
    EXPECT_EQ(bench.run(RgbOp::Mad, AlphaOp::Mad, a, b)[3], expected[0]) << int(operation);
  }
}

TEST(Execute, ModifiersThenClampThenMask) {
  const float kFactors[] = {1, 2, 4, 8, 0.5f, 0.25f, 0.125f};
  for (int i = 0; i < 7; ++i) {
    Bench bench;
    bench.rgb().arguments[1].select = RgbSelect::One;
    bench.alpha().arguments[1].select = AlphaSelect::One;
    bench.rgb().modifier = Modifier(i);
    bench.alpha().modifier = Modifier(6 - i);
    bench.rgb().clamp = true;
    bench.rgb().outputMask = 5;
    const Vec4 seen = bench.run(RgbOp::Mad, AlphaOp::Mad, {0.125f, 1, -1, 16});
    EXPECT_EQ(seen, (Vec4{std::fmin(0.125f * kFactors[i], 1.0f), 0, 0, 16 * kFactors[6 - i]})) << i;
  }
}

TEST(Execute, ReplicationComesBeforeModifierAndClamp) {
  Bench bench;
  bench.alpha().clamp = true;
  bench.rgb().modifier = Modifier::X2;
  EXPECT_EQ(bench.run(RgbOp::ReplAlpha, AlphaOp::Rcp, {0, 0, 0, 0.25f}), (Vec4{8, 8, 8, 1}));
}

TEST(Execute, DepthIsTheAlphaHalfsResult) {
  Bench bench;
  bench.run(RgbOp::Mad, AlphaOp::Rcp, {1, 1, 1, 8});
  EXPECT_FALSE(bench.evaluation.depth);
  bench.alpha().depth = true;
  bench.run(RgbOp::Mad, AlphaOp::Rcp, {1, 1, 1, 8});
  EXPECT_EQ(bench.evaluation.depth, 0.125f);
}

TEST(Execute, APairReadsBeforeItWrites) {
  Bench bench;
  bench.code.temporaries = 1;
  bench.code.pairs.insert(bench.code.pairs.begin(), bench.code.pairs[0]);
  bench.code.nodes[0].pairs = 2;
  for (int i = 0; i < 2; ++i) {
    Pair &pair = bench.code.pairs[std::size_t(i)];
    pair.rgb.op = RgbOp::Mad;
    pair.alpha.op = AlphaOp::Mad;
    pair.rgb.temporary = pair.alpha.temporary = 0;
    pair.rgb.mask = 7;
    pair.alpha.mask = 8;
    pair.rgb.arguments[1] = pair.rgb.arguments[2] = {i ? RgbSelect::One : RgbSelect::Zero};
    pair.alpha.arguments[1] = pair.alpha.arguments[2] = {i ? AlphaSelect::One : AlphaSelect::Zero};
    pair.rgb.arguments[2] = {RgbSelect::Half};
    pair.alpha.arguments[2] = {AlphaSelect::Half};
  }
  // The code sets r0 = 1/2; then r0.xyz = r0.www + 1/2 and r0.w = r0.x + 1/2.
  Pair &second = bench.code.pairs[1];
  second.rgb.sources[0] = second.alpha.sources[0] = reg(0);
  second.rgb.arguments[0].select = RgbSelect::Www;
  second.alpha.arguments[0].select = AlphaSelect::X;
  for (const Fault &fault : faults(bench.code, bench.program))
    ADD_FAILURE() << fault.text;
  EXPECT_EQ(execute(bench.code, bench.program, {}).outputs[0], (Vec4{1, 1, 1, 1}));
}

/// Returns a texel whose components encode the request.
Vec4 asked(const ir::Sample &s) {
  return {s.coordinate[0], s.coordinate[1], s.coordinate[2], float(s.unit) + 100 * s.bias};
}

struct Fetch {
  TexOp op;
  ir::TexTarget target;
  Vec4 texel;
};

TEST(Execute, Samples) {
  const Vec4 place = {8, 4, 2, 0.5f};
  const Fetch kFetches[] = {
      {TexOp::Load, ir::TexTarget::Tex1D, {8, 0, 0, 3}},
      {TexOp::Load, ir::TexTarget::Tex2D, {8, 4, 0, 3}},
      {TexOp::Load, ir::TexTarget::Cube, {8, 4, 2, 3}},
      {TexOp::Project, ir::TexTarget::Tex3D, {16, 8, 4, 3}},
      {TexOp::Bias, ir::TexTarget::Tex2D, {8, 4, 0, 53}},
      {TexOp::Bias, ir::TexTarget::Rect, {8, 4, 0, 3}},
      // The stored depth in all four components; the ALU compares.
      {TexOp::Load, ir::TexTarget::Shadow2D, {8, 8, 8, 8}},
      {TexOp::Project, ir::TexTarget::Shadow1D, {16, 16, 16, 16}},
  };
  for (const Fetch &fetch : kFetches) {
    Bench bench;
    const auto opcode = fetch.op == TexOp::Load      ? ir::Opcode::Tex
                        : fetch.op == TexOp::Project ? ir::Opcode::Txp
                                                     : ir::Opcode::Txb;
    ir::Builder b;
    b.tex(opcode, b.color(), b.attribute(ir::AttributeKind::TexCoord), 3, fetch.target);
    bench.program = b.take();
    bench.code.temporaries = 1;
    bench.code.interpolators = 1;
    bench.code.interpolants = {{0, 0}};
    bench.code.textures = {{fetch.op, 3, fetch.target, 0, 0, 0}};
    bench.code.nodes[0].textures = 1;
    bench.rgb().sources[0] = bench.alpha().sources[0] = reg(0);
    bench.rgb().arguments[1] = {RgbSelect::One};
    bench.alpha().arguments[1] = {AlphaSelect::One};
    bench.rgb().op = RgbOp::Mad;
    bench.alpha().op = AlphaOp::Mad;
    for (const Fault &fault : faults(bench.code, bench.program))
      ADD_FAILURE() << fault.text;
    ir::Inputs inputs;
    inputs.attributes = {&place, 1};
    inputs.texture = asked;
    EXPECT_EQ(execute(bench.code, bench.program, inputs).outputs[0], fetch.texel)
        << int(fetch.op) << " " << int(fetch.target);
    if (fetch.target != ir::TexTarget::Rect)
      continue;
    // If its constants have the scale, the program gives coordinates in [0,1].
    bench.code.constants[2].kind = Constant::Kind::RectangleScale;
    bench.code.constants[2].index = 3;
    bench.rgb().arguments[2] = {RgbSelect::Zero};
    bench.alpha().arguments[2] = {AlphaSelect::Zero};
    EXPECT_EQ(execute(bench.code, bench.program, inputs).outputs[0],
              (Vec4{8 * kRectangleWidth, 4 * kRectangleHeight, 0, 3}));
  }
}

TEST(Execute, SamplesOfANodeReadWhatItFound) {
  Code code = sampleCode();
  // Two samples of node 1 exchange r0 and r1.
  code.textures[1] = {TexOp::Load, 1, ir::TexTarget::Tex2D, 0, 2, 3};
  code.textures[2] = {TexOp::Load, 1, ir::TexTarget::Tex2D, 2, 0, 3};
  code.textures[0].destination = 2;
  code.nodes[1].pairs = 1;
  code.pairs.resize(2);
  Pair &sum = code.pairs[1];
  sum = {};
  sum.rgb.op = RgbOp::Mad;
  sum.rgb.sources = {reg(0), reg(2), {}};
  sum.rgb.arguments = {RgbArgument{RgbSelect::Xyz, 0}, {RgbSelect::Half}, {RgbSelect::Xyz, 1}};
  sum.rgb.outputMask = 7;
  const Vec4 attributes[] = {{1, 2, 3, 4}, {}};
  ir::Inputs inputs;
  inputs.attributes = attributes;
  inputs.texture = [](const ir::Sample &s) {
    return Vec4{s.coordinate[0] + 10, s.coordinate[1] + 10, 0, 0};
  };
  // First r2 = (11, 12). Then r2 = (11, 12) from r0, and r0 = (21, 22) from the old r2: 21/2 + 11.
  const ir::Evaluation seen = execute(code, sampleProgram(), inputs);
  ASSERT_EQ(seen.outputs.size(), 2u);
  const Vec4 &color =
      seen.outputs[sampleProgram().outputs[0].kind == ir::OutputKind::Color ? 0 : 1];
  EXPECT_EQ(color[0], 21.5f);
  EXPECT_EQ(color[1], 23.0f);
}

TEST(Execute, TheSampleGivesWhatItsProgramDoes) {
  const ir::Program program = sampleProgram();
  const Vec4 attributes[] = {{0.5f, 0.25f, 2, 4}, {1, 0.5f, 0.25f, 1}};
  for (const float first : {0.5f, -0.5f}) {
    Vec4 moved[] = {attributes[0], attributes[1]};
    moved[0][0] = first;
    ir::Inputs inputs;
    inputs.attributes = moved;
    inputs.parameter = [](const ir::Parameter &) { return Vec4{-1, -0.5f, -0.25f, -1}; };
    inputs.texture = asked;
    const ir::Evaluation expected = ir::evaluate(program, inputs);
    ir::Evaluation seen = execute(sampleCode(), program, inputs);
    EXPECT_EQ(expected.killed, first < 0);
    EXPECT_EQ(seen.killed, expected.killed);
    EXPECT_EQ(seen.depth, expected.depth);
    for (std::size_t o = 0; o < program.outputs.size(); ++o) {
      if (program.outputs[o].kind == ir::OutputKind::Color) {
        EXPECT_EQ(seen.outputs[o], expected.outputs[o]);
      }
    }
  }
}

/// Returns colour 0 of a program that moves interpolant 0 there.
Vec4 interpolated(ir::AttributeKind kind, const Vec4 &value) {
  Bench bench;
  ir::Builder b;
  b.op(ir::Opcode::Mov, b.color(), {b.attribute(kind)});
  bench.program = b.take();
  bench.code.interpolants = {{0, 0}};
  bench.code.temporaries = 1;
  bench.rgb().sources[0] = bench.alpha().sources[0] = reg(0);
  bench.rgb().op = RgbOp::Max;
  bench.alpha().op = AlphaOp::Max;
  bench.code.pairs[0].rgb.arguments[1].source = bench.code.pairs[0].alpha.arguments[1].source = 0;
  ir::Inputs inputs;
  inputs.attributes = {&value, 1};
  return execute(bench.code, bench.program, inputs).outputs[0];
}

TEST(Execute, InterpolantsHaveTheChipsForms) {
  const Vec4 value = {12, 4, 0.75f, 0.5f};
  EXPECT_EQ(interpolated(ir::AttributeKind::TexCoord, value), value);
  EXPECT_EQ(interpolated(ir::AttributeKind::FogCoord, value), (Vec4{12, 0, 0, 1}));
  const Vec4 clip = interpolated(ir::AttributeKind::Position, value);
  EXPECT_EQ(clip[3], 2.0f);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(clip[i] / clip[3] * kViewportScale[i] + kViewportOffset[i], value[i]);
}

TEST(Execute, FogConstants) {
  Bench bench;
  bench.code.constants[0].kind = Constant::Kind::FogFactors;
  bench.code.constants[1].kind = Constant::Kind::FogColor;
  bench.rgb().arguments[2] = {RgbSelect::Zero};
  bench.alpha().arguments[2] = {AlphaSelect::Zero};
  bench.rgb().op = RgbOp::Mad;
  bench.alpha().op = AlphaOp::Mad;
  ir::Inputs inputs;
  inputs.parameter = [](const ir::Parameter &p) {
    return p.state.item == ir::StateItem::FogColor ? Vec4{1, 2, 4, 8} : Vec4{1, 2, 6, 99};
  };
  const Vec4 seen = execute(bench.code, bench.program, inputs).outputs[0];
  EXPECT_EQ(seen[0], -0.25f);
  EXPECT_EQ(seen[1], 3.0f);
  EXPECT_FLOAT_EQ(seen[2], -4 * 1.4426950f);
  EXPECT_FLOAT_EQ(seen[3], 8 * 1.2011224f);
}

} // namespace
} // namespace arbiter::fp::hw::r300
