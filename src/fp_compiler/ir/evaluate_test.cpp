#include "fp_compiler/ir/evaluate.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/specials.h"

namespace arbiter::fp::ir {
namespace {

using testing::kInf;
using testing::kNan;

Vec4 apply1(Opcode op, Vec4 a, Vec4 b = {}, Vec4 c = {}) {
  return apply(op, {a, b, c}, Numerics::Host);
}
float scalar(Opcode op, float a, float b = 0) { return apply1(op, {a, a, a, a}, {b, b, b, b})[0]; }

Vec4 colorOf(const Builder &b, const Inputs &inputs = {}) {
  EXPECT_TRUE(validate(b.program()).empty());
  return evaluate(b.program(), inputs).outputs.at(0);
}

TEST(Semantics, ZeroToTheZeroIsOne) {
  EXPECT_EQ(scalar(Opcode::Pow, 0, 0), 1.0f);
  EXPECT_EQ(scalar(Opcode::Pow, kNan, 0), 1.0f);
  EXPECT_EQ(apply1(Opcode::Lit, {1, 0, 9, 0})[2], 1.0f);
  EXPECT_EQ(apply1(Opcode::Lit, {1, -5, 9, 0})[2], 1.0f);
}

TEST(Semantics, PowOfBelowZeroIsZero) {
  EXPECT_EQ(scalar(Opcode::Pow, -2, 2), 0.0f);
  EXPECT_EQ(scalar(Opcode::Pow, -2, -1), 0.0f);
  EXPECT_EQ(scalar(Opcode::Pow, kNan, 3), 0.0f);
  EXPECT_EQ(scalar(Opcode::Pow, 2, 3), 8.0f);
}

TEST(Semantics, LitClampsAndForcesSpecular) {
  EXPECT_EQ(apply1(Opcode::Lit, {-1, 0.5f, 0, 1}), (Vec4{1, 0, 0, 1}));
  EXPECT_EQ(apply1(Opcode::Lit, {0, 0.5f, 0, 1}), (Vec4{1, 0, 0, 1}));
  EXPECT_EQ(apply1(Opcode::Lit, {0.25f, 0.5f, 0, 2}), (Vec4{1, 0.25f, 0.25f, 1}));
  // POW would underflow to zero if the exponent were not clamped.
  EXPECT_GT(apply1(Opcode::Lit, {1, 0.6f, 0, 1000})[2], 0.0f);
}

TEST(Semantics, MinMaxPassOverNan) {
  EXPECT_EQ(scalar(Opcode::Max, kNan, 2), 2.0f);
  EXPECT_EQ(scalar(Opcode::Max, 2, kNan), 2.0f);
  EXPECT_EQ(scalar(Opcode::Min, kNan, 2), 2.0f);
  EXPECT_TRUE(std::signbit(scalar(Opcode::Min, 0.0f, -0.0f)));
  EXPECT_FALSE(std::signbit(scalar(Opcode::Max, -0.0f, 0.0f)));
}

TEST(Semantics, ComparisonsWithNanAreFalse) {
  EXPECT_EQ(scalar(Opcode::Sge, kNan, 0), 0.0f);
  EXPECT_EQ(scalar(Opcode::Slt, kNan, 0), 0.0f);
  EXPECT_EQ(apply1(Opcode::Cmp, {kNan, -0.0f, -1, 1}, {1, 1, 1, 1}, {2, 2, 2, 2}),
            (Vec4{2, 2, 1, 2}));
}

TEST(Semantics, RootsLogarithmsReciprocals) {
  EXPECT_EQ(scalar(Opcode::Rsq, -4), 0.5f);
  EXPECT_EQ(scalar(Opcode::Rsq, 0), kInf);
  EXPECT_EQ(scalar(Opcode::Rcp, -0.0f), -kInf);
  EXPECT_EQ(scalar(Opcode::Lg2, 0), -kInf);
  EXPECT_TRUE(std::isnan(scalar(Opcode::Lg2, -1)));
  EXPECT_EQ(scalar(Opcode::Ex2, -200), 0.0f);
}

TEST(Semantics, DenormalsAreZero) {
  EXPECT_EQ(scalar(Opcode::Mul, 1e-40f, 1e30f), 0.0f);
  EXPECT_EQ(scalar(Opcode::Rcp, 1e-40f), kInf);
  EXPECT_EQ(scalar(Opcode::Mul, 1e-30f, 1e-30f), 0.0f);
}

TEST(Semantics, SaturateTurnsNanToZero) {
  EXPECT_EQ(saturated(kNan), 0.0f);
  EXPECT_EQ(saturated(kInf), 1.0f);
  EXPECT_EQ(saturated(-1), 0.0f);
}

TEST(Semantics, VectorsOfFixedForm) {
  EXPECT_EQ(apply1(Opcode::Dst, {9, 2, 3, 9}, {9, 5, 9, 7}), (Vec4{1, 10, 3, 7}));
  EXPECT_EQ(apply1(Opcode::Xpd, {1, 0, 0, 5}, {0, 1, 0, 5}), (Vec4{0, 0, 1, 0}));
  EXPECT_EQ(apply1(Opcode::Scs, {0, 9, 9, 9}), (Vec4{1, 0, 0, 0}));
  EXPECT_EQ(apply1(Opcode::Dph, {1, 2, 3, 100}, {1, 1, 1, 7})[3], 13.0f);
}

TEST(Evaluate, DestinationMayBeASource) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mov, t, {b.constant(1, 2, 3, 4)});
  b.op(Opcode::Mov, t.mask("xyz"), {t.read().swz("yzxw")});
  b.op(Opcode::Mov, b.color(), {t.read()});
  EXPECT_EQ(colorOf(b), (Vec4{2, 3, 1, 4}));
}

TEST(Evaluate, UnwrittenIsZero) {
  Builder b;
  b.op(Opcode::Mov, b.color().mask("y"), {b.temporary().read().swz("1")});
  EXPECT_EQ(colorOf(b), (Vec4{0, 1, 0, 0}));
}

TEST(Evaluate, SwizzleTakesItsSignsAlong) {
  Builder b;
  b.op(Opcode::Swz, b.color(), {b.constant(1, 2, 3, 4).negated(0b0101).swz("1zx0").negated(1)});
  EXPECT_EQ(colorOf(b), (Vec4{-1, -3, -1, 0}));
}

TEST(Evaluate, ObserverSeesEachInstructionWhenItIsDone) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mov, t.mask("xw"), {-b.constant(1, 2, 3, 4)});
  b.tex(Opcode::Txp, t.mask("y").sat(), t.read().swz("xyzw"), 3, TexTarget::Tex2D);
  b.kil(t.read());
  b.op(Opcode::Mov, b.color(), {t.read()});
  std::vector<Step> steps;
  Inputs inputs;
  inputs.texture = [](const Sample &) { return Vec4{5, 6, 7, 8}; };
  inputs.observer = [&](const Step &step) { steps.push_back(step); };
  (void)evaluate(b.program(), inputs);
  ASSERT_EQ(steps.size(), 3u) << "the fragment ends at KIL";
  EXPECT_EQ(steps[0].operands[0], (Vec4{-1, -2, -3, -4}));
  EXPECT_EQ(steps[0].value, (Vec4{-1, 0, 0, -4})) << "the whole register";
  ASSERT_TRUE(steps[1].sample);
  EXPECT_EQ(steps[1].sample->coordinate, (Vec4{0.25f, 0, 0, 0}));
  EXPECT_EQ(steps[1].value, (Vec4{-1, 1, 0, -4})) << "y is saturated";
  EXPECT_TRUE(steps[2].discards);
  EXPECT_EQ(steps[2].index, 2u);

  steps.clear();
  inputs.pastKill = true;
  const Evaluation end = evaluate(b.program(), inputs);
  EXPECT_EQ(steps.size(), 4u);
  EXPECT_TRUE(end.killed);
  EXPECT_EQ(end.outputs.at(0), (Vec4{-1, 1, 0, -4})) << "what it would have been";
}

TEST(Evaluate, KilStopsTheFragment) {
  for (const float value : {-1.0f, -0.0f, 0.0f, kNan, 1.0f, -kInf}) {
    Builder b;
    b.op(Opcode::Mov, b.color(), {b.constant(1)});
    b.kil(b.constant(1, 1, value, 1));
    EXPECT_EQ(evaluate(b.program(), {}).killed, value < 0) << value;
  }
}

TEST(Evaluate, TexturesDivideAndBias) {
  Builder b;
  const auto coordinate = b.constant(2, 4, 6, 2);
  b.tex(Opcode::Txp, b.color().mask("x"), coordinate, 1, TexTarget::Tex3D);
  b.tex(Opcode::Txb, b.color().mask("y"), coordinate, 1, TexTarget::Tex3D);
  b.tex(Opcode::Tex, b.color().mask("z"), coordinate, 1, TexTarget::Tex3D);
  Inputs inputs;
  inputs.texture = [](const Sample &s) {
    const float sum =
        s.coordinate[0] + 10 * s.coordinate[1] + 100 * s.coordinate[2] + 1000 * s.bias;
    return Vec4{sum, sum, sum, sum};
  };
  EXPECT_EQ(colorOf(b, inputs), (Vec4{321, 2642, 642, 0}));
}

TEST(Evaluate, DepthIsItsZ) {
  Builder b;
  b.op(Opcode::Mov, b.depth(), {b.constant(1, 2, 0.25f, 4)});
  EXPECT_EQ(evaluate(b.program(), {}).depth, 0.25f);
  Builder none;
  none.op(Opcode::Mov, none.depth().mask("x"), {none.constant(1)});
  EXPECT_FALSE(evaluate(none.program(), {}).depth.has_value());
}

TEST(Evaluate, FogOptionsBlendTheClampedColor) {
  Builder b;
  b.options().fog = FogMode::Linear;
  b.op(Opcode::Mov, b.color(), {b.constant(2, 0.5f, -1, 3)});
  Inputs inputs;
  inputs.fogCoordinate = 3;
  inputs.parameter = [](const Parameter &p) {
    return p.state.item == StateItem::FogColor ? Vec4{0, 1, 1, 1} : Vec4{1, 0, 4, 0.25f};
  };
  EXPECT_EQ(colorOf(b, inputs), (Vec4{0.25f, 0.875f, 0.75f, 1}));
}

TEST(Validate, FindsEachBreach) {
  const auto breaches = [](auto change) {
    Builder b;
    const auto t = b.temporary();
    b.op(Opcode::Pow, t, {b.local(0).swz("x"), b.local(1).swz("y")});
    b.tex(Opcode::Tex, t, t.read(), 0, TexTarget::Tex2D);
    b.op(Opcode::Mov, b.color(), {t.read()});
    Program program = b.take();
    EXPECT_TRUE(validate(program).empty());
    change(program);
    return validate(program).size();
  };
  EXPECT_EQ(breaches([](Program &p) { p.code[2].dst.mask = 0; }), 1u);
  EXPECT_EQ(breaches([](Program &p) { p.code[2].dst.index = 1; }), 1u);
  EXPECT_EQ(breaches([](Program &p) { p.code[2].dst.file = File::Parameter; }), 1u);
  EXPECT_EQ(breaches([](Program &p) { p.code[2].src[0].file = File::Output; }), 1u);
  EXPECT_EQ(breaches([](Program &p) { p.code[2].src[0].index = 7; }), 1u);
  EXPECT_EQ(breaches([](Program &p) { p.code[0].src[0].negate = 1; }), 1u);
  EXPECT_EQ(breaches([](Program &p) { p.code[0].src[1].swizzle = kIdentity; }), 1u);
  EXPECT_EQ(breaches([](Program &p) { p.code[1].unit = 99; }), 1u);
  EXPECT_EQ(breaches([](Program &p) { p.code[1].target = TexTarget::Shadow2D; }), 1u);
  EXPECT_EQ(breaches([](Program &p) {
              p.code.push_back(p.code[1]);
              p.code.back().target = TexTarget::Cube;
            }),
            1u);
  EXPECT_EQ(breaches([](Program &p) { p.outputs.push_back(p.outputs[0]); }), 1u);
}

TEST(Print, ListsTablesAndCode) {
  Builder b;
  b.options().fog = FogMode::Exp;
  b.options().shadow = true;
  const auto t = b.temporary("light");
  StateRef row;
  row.item = StateItem::MatrixProgram;
  row.index = 2;
  row.modifier = MatrixModifier::InvTrans;
  row.row = 3;
  b.op(Opcode::Mad, t.mask("xw").sat(),
       {b.attribute(AttributeKind::TexCoord, 2), -b.constant(0.1f).swz("wzyx"),
        b.state(row).swz("x01y").negated(5)});
  b.op(Opcode::Rcp, t.mask("x"), {-t.read().swz("w")});
  b.tex(Opcode::Txp, b.color(), t.read(), 3, TexTarget::Shadow2D);
  b.kil(t.read());
  EXPECT_EQ(print(b.program()), "option ARB_fog_exp\noption ARB_fragment_program_shadow\n"
                                "a0 = fragment.texcoord[2]\n"
                                "p0 = {0.1, 0.1, 0.1, 0.1}\n"
                                "p1 = state.matrix.program[2].invtrans.row[3]\n"
                                "t0 = temporary light\no0 = result.color[0]\n"
                                "  MAD_SAT t0.xw, a0, -p0.wzyx, p1.(-x,0,-1,y)\n"
                                "  RCP t0.x, -t0.w\n"
                                "  TXP o0, t0, texture[3], SHADOW2D\n"
                                "  KIL t0\n");
}

Vec4 bits(Opcode op, Vec4 a, Vec4 b = {}, Vec4 c = {}) { return applyToBits(op, {a, b, c}); }

/// The bits of a signalling NaN must survive wherever they are carried.
TEST(Semantics, PackedBytesOfANanStay) {
  const Vec4 numbers = {1, 0, 0, 1}, less = {-1, -1, -1, -1};
  const Vec4 packed = bits(Opcode::Pk4b, numbers);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(packed[0]), 0xFF8080FFu);
  EXPECT_EQ(bits(Opcode::Up4b, packed), numbers);
  EXPECT_EQ(bits(Opcode::Up4b, bits(Opcode::Mov, packed)), numbers);
  EXPECT_EQ(bits(Opcode::Up4b, bits(Opcode::Cmp, less, packed)), numbers);
  EXPECT_EQ(bits(Opcode::Up4b, bits(Opcode::Cmp, numbers, {}, packed)), numbers);
}

} // namespace
} // namespace arbiter::fp::ir
