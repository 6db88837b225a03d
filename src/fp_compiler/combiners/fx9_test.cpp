#include <algorithm>
#include <gtest/gtest.h>

#include "fp_compiler/combiners/lower.h"
#include "fp_compiler/emit.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/testing/evaluate_combiners_fx9.h"

namespace arbiter::fp::combiners {
namespace {

/// One case of a general combiner. Its red result, in 255ths, depends on a primary colour of `red`
/// 255ths and on constants.
struct Case {
  State state;
  Inputs inputs;

  explicit Case(double red = 0.0) {
    inputs.primary = {red / 255.0, 0.0, 0.0, 1.0};
    Portion &rgb = state.stages[0].rgb;
    rgb.inputs[0] = {Register::Primary, Mapping::SignedIdentity, Usage::Rgb};
    for (Input &input : state.finals)
      input = {Register::Zero, Mapping::UnsignedIdentity, Usage::Rgb};
    state.finals[3] = {Register::Spare0, Mapping::UnsignedIdentity, Usage::Rgb};
  }
  Portion &rgb() { return state.stages[0].rgb; }

  /// Returns the result of the IR for the mode. Checks that the independent evaluator gives the
  /// same.
  [[nodiscard]] double red() const {
    Surroundings around;
    around.fx9 = true;
    const ir::Program program = lower(state, around);
    ir::Inputs given;
    std::vector<ir::Vec4> attributes;
    for (const ir::Attribute &row : program.attributes)
      attributes.push_back(
          single(row.kind == ir::AttributeKind::ColorPrimary ? inputs.primary : inputs.secondary));
    given.attributes = attributes;
    given.numerics = Numerics::Fx9;
    given.parameter = [this](const ir::Parameter &row) {
      return single(inputs.constants[row.index]);
    };
    const double found = double(ir::evaluate(program, given).outputs[0][0]) * 255.0;
    EXPECT_NEAR(found, evaluateFx9(state, inputs).color[0] * 255.0, 1e-3) << ir::print(program);
    return found;
  }

  static ir::Vec4 single(const Color &v) {
    return {float(v[0]), float(v[1]), float(v[2]), float(v[3])};
  }
};

/// 100.4 / 255 is stored as 100 and 100.5 as 101. Values out of range are clamped.
TEST(Fx9, WhatIsGivenIsRounded) {
  EXPECT_NEAR(Case(100.4).red(), 100.0, 1e-3);
  EXPECT_NEAR(Case(100.6).red(), 101.0, 1e-3);
  EXPECT_NEAR(Case(300.0).red(), 255.0, 1e-3);
  Case negative(-20.6);
  negative.rgb().inputs[0].mapping = Mapping::SignedNegate;
  EXPECT_NEAR(negative.red(), 21.0, 1e-3);
}

/// 100 * 51 / 255 = 20; 100 * 50 / 255 = 19.608, which gives 20; 100 * 49 / 255 = 19.216, which
/// gives 19.
TEST(Fx9, AProductIsRounded) {
  for (const auto &[factor, product] :
       {std::pair{51, 20}, {50, 20}, {49, 19}, {255, 100}, {1, 0}}) {
    Case of(100);
    of.rgb().inputs[1] = {Register::Constant0, Mapping::SignedIdentity, Usage::Rgb};
    of.inputs.constants[0][0] = factor / 255.0;
    EXPECT_NEAR(of.red(), product, 1e-3) << factor;
  }
}

/// A product with one is a whole number already and needs no rounding.
TEST(Fx9, AProductWithOneIsNotRounded) {
  const auto roundings = [](const Case &of) {
    Surroundings around;
    around.fx9 = true;
    ir::Program program = lower(of.state, around);
    optimise(program, Numerics::Fx9);
    return std::count_if(program.code.begin(), program.code.end(),
                         [](const auto &each) { return each.op == ir::Opcode::Flr; });
  };
  const Input one = {Register::Zero, Mapping::UnsignedInvert, Usage::Rgb};
  Case of(101);
  of.rgb().inputs[1] = one;
  EXPECT_NEAR(of.red(), 101.0, 1e-3);
  EXPECT_EQ(roundings(of), 1) << "the colour that is given";
  of.rgb().inputs[2] = {Register::Constant0, Mapping::SignedIdentity, Usage::Rgb};
  of.rgb().inputs[3] = one;
  of.inputs.constants[0][0] = 50 / 255.0;
  EXPECT_NEAR(of.red(), 151.0, 1e-3);
  EXPECT_EQ(roundings(of), 2) << "the constant too";
  of.rgb().scale = Scale::ByOneHalf;
  EXPECT_NEAR(of.red(), 76.0, 1e-3) << "75.5";
  EXPECT_EQ(roundings(of), 3) << "a half may be between";
  of.rgb().inputs[3] = of.rgb().inputs[2];
  of.rgb().scale = Scale::None;
  EXPECT_NEAR(of.red(), 111.0, 1e-3) << "101 + 9.8";
  EXPECT_EQ(roundings(of), 3);
}

/// A sum is rounded once: 10 * 10 / 255 = 0.392 gives 0 by itself, but 0.392 + 0.392 gives 1.
TEST(Fx9, ASumOfProductsIsRoundedOnce) {
  Case of(10);
  of.inputs.constants[0][0] = 10 / 255.0;
  for (const std::size_t v : {1u, 3u})
    of.rgb().inputs[v] = {Register::Constant0, Mapping::SignedIdentity, Usage::Rgb};
  of.rgb().inputs[2] = of.rgb().inputs[0];
  EXPECT_NEAR(of.red(), 1.0, 1e-3); // 200 / 255
  of.rgb().inputs[3].mapping = Mapping::UnsignedInvert;
  EXPECT_NEAR(of.red(), 10.0, 1e-3); // (100 + 10 * 245) / 255
}

/// A scale of one half gives 50.5 for 101, which rounds to 51, and -50.5 for -101, which rounds to
/// -50.
TEST(Fx9, HalvesGoUpward) {
  Case of(101);
  of.rgb().scale = Scale::ByOneHalf;
  EXPECT_NEAR(of.red(), 51.0, 1e-3);
  of.rgb().inputs[0].mapping = Mapping::SignedNegate;
  of.state.finals[3].mapping = Mapping::UnsignedInvert; // shows a negative value as one
  EXPECT_NEAR(of.red(), 255.0, 1e-3);
  of.state.count = 2; // the second stage negates it again
  of.state.stages[1].rgb.inputs[0] = {Register::Spare0, Mapping::SignedNegate, Usage::Rgb};
  of.state.finals[3].mapping = Mapping::UnsignedIdentity;
  EXPECT_NEAR(of.red(), 50.0, 1e-3);
}

/// One half is 128 of 255. Either half-bias mapping maps a byte of 128 to zero.
TEST(Fx9, OneHalfIsANumberToo) {
  for (const Mapping mapping : {Mapping::HalfBiasNormal, Mapping::HalfBiasNegate}) {
    Case of(128);
    of.rgb().inputs[0].mapping = mapping;
    EXPECT_NEAR(of.red(), 0.0, 1e-3);
  }
  Case of(130);
  of.rgb().bias = true;
  of.rgb().scale = Scale::ByFour;
  EXPECT_NEAR(of.red(), 8.0, 1e-3);
  Case expanded(128);
  expanded.rgb().inputs[0].mapping = Mapping::ExpandNormal; // 2 * 128 - 255
  EXPECT_NEAR(expanded.red(), 1.0, 1e-3);
}

/// A mux selects CD from 128 on.
TEST(Fx9, AMuxComparesNumbers) {
  for (const int chooser : {127, 128}) {
    Case of(200);
    of.rgb().mux = true;
    of.state.count = 2;
    of.state.stages[1] = of.state.stages[0];
    of.state.stages[0].rgb = initialPortion(Usage::Rgb);
    of.state.stages[0].alpha.inputs[0] = {Register::Constant0, Mapping::SignedIdentity,
                                          Usage::Alpha};
    of.inputs.constants[0][3] = chooser / 255.0;
    EXPECT_NEAR(of.red(), chooser < 128 ? 200.0 : 0.0, 1e-3);
  }
}

TEST(Fx9, CodeOfCombinersHasItForEveryBackEnd) {
  Surroundings around;
  const std::string without = emitGlsl(lower({}, around), {}, Numerics::Fx9).text;
  around.fx9 = true;
  const std::string with = emitGlsl(lower({}, around), {}, Numerics::Fx9).text;
  EXPECT_EQ(without.find("floor"), std::string::npos);
  EXPECT_NE(with.find("floor"), std::string::npos) << with;
}

} // namespace
} // namespace arbiter::fp::combiners
