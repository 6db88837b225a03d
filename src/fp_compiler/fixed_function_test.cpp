#include "fp_compiler/fixed_function.h"

#include <gtest/gtest.h>

#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/validate.h"

namespace arbiter::fp {
namespace {

using ir::AttributeKind;
using ir::Builder;
using ir::Opcode;
using ir::TexTarget;

/// Returns a program that computes twice the sample of unit 1, plus that of unit 0.
ir::Program sampling() {
  Builder b(ir::Language::AtiFragment);
  const auto first = b.temporary(), second = b.temporary();
  const auto coordinate = b.attribute(AttributeKind::TexCoord, 0);
  b.tex(Opcode::Tex, first, coordinate, 0, TexTarget::Tex2D);
  b.tex(Opcode::Tex, second, coordinate, 1, TexTarget::Tex2D);
  b.op(Opcode::Mad, b.color(), {second.read(), b.constant(2), first.read()});
  return b.take();
}

TEST(FixedFunction, SamplesTakeTheirUnitsTargets) {
  FixedFunction state;
  state.targets = {TexTarget::Cube, TexTarget::Shadow2D};
  const ir::Program program = withFixedFunction(sampling(), state);
  EXPECT_EQ(program.code[0].target, TexTarget::Cube);
  EXPECT_EQ(program.code[1].target, TexTarget::Shadow2D);
  for (const std::string &problem : ir::validate(program))
    ADD_FAILURE() << problem;
  const GlslShader shader = emitGlsl(program);
  ASSERT_EQ(shader.samplers.size(), 2u);
  EXPECT_NE(shader.text.find("textureCube(arb_tex0, gl_TexCoord[0].xyz)"), std::string::npos)
      << shader.text;
  EXPECT_NE(shader.text.find("shadow2D(arb_tex1"), std::string::npos) << shader.text;
}

TEST(FixedFunction, DisabledUnitsReadAsIncompleteTextures) {
  FixedFunction state;
  state.disabledUnits = 2;
  const ir::Program program = withFixedFunction(sampling(), state);
  for (const std::string &problem : ir::validate(program))
    ADD_FAILURE() << problem;
  EXPECT_EQ(emitGlsl(program).samplers.size(), 1u) << "the other unit is sampled";
  state.disabledUnits = 3;
  EXPECT_EQ(ir::evaluate(withFixedFunction(sampling(), state), {}).outputs[0],
            (ir::Vec4{0, 0, 0, 3}));
}

TEST(FixedFunction, StateOfOneDrawDoesNotStay) {
  FixedFunction first;
  first.fog = ir::FogMode::Exp;
  first.colorSum = true;
  const ir::Program once = withFixedFunction(sampling(), first);
  EXPECT_EQ(once.options.fog, ir::FogMode::Exp);
  EXPECT_TRUE(once.options.colorSum);
  const ir::Program again = withFixedFunction(once, {});
  EXPECT_EQ(again.options.fog, ir::FogMode::None);
  EXPECT_FALSE(again.options.colorSum);
}

/// The colour is (2, 0.25, -1, 0.5), the secondary (0.5, 0.5, 0.5), and the fog black with a factor
/// of 0.5.
TEST(FixedFunction, ClampsBeforeTheSumAndBeforeTheFog) {
  Builder b(ir::Language::AtiFragment);
  b.op(Opcode::Mov, b.color(), {b.constant(2, 0.25f, -1, 0.5f)});
  FixedFunction state;
  state.colorSum = true;
  ir::Inputs inputs;
  inputs.secondary = {0.5f, 0.5f, 0.5f, 0.5f};
  EXPECT_EQ(ir::evaluate(withFixedFunction(b.program(), state), inputs).outputs[0],
            (ir::Vec4{1.5f, 0.75f, 0.5f, 0.5f}));
  state.fog = ir::FogMode::Linear;
  inputs.fogCoordinate = 0.5f;
  inputs.parameter = [](const ir::Parameter &row) {
    return row.state.item == ir::StateItem::FogParams ? ir::Vec4{1, 0, 1, 1} : ir::Vec4{};
  };
  EXPECT_EQ(ir::evaluate(withFixedFunction(b.program(), state), inputs).outputs[0],
            (ir::Vec4{0.5f, 0.375f, 0.25f, 0.5f}));
}

TEST(FixedFunction, AsAnArbProgramItAddsTheSecondaryItself) {
  Builder b(ir::Language::AtiFragment);
  b.op(Opcode::Mov, b.color(), {b.constant(2, 0.25f, -1, 0.5f)});
  FixedFunction state;
  state.colorSum = true;
  state.fog = ir::FogMode::Linear;
  const ir::Program own = withFixedFunction(b.program(), state);
  const ir::Program arb = asArbFragment(own);
  EXPECT_EQ(arb.language, ir::Language::ArbFragment);
  EXPECT_FALSE(arb.options.colorSum);
  for (const std::string &problem : ir::validate(arb))
    ADD_FAILURE() << problem;
  ir::Inputs inputs;
  const std::array<ir::Vec4, 1> attributes = {ir::Vec4{0.5f, 0.5f, 0.5f, 0.5f}};
  inputs.secondary = attributes[0];
  inputs.attributes = attributes;
  inputs.fogCoordinate = 0.5f;
  inputs.parameter = [](const ir::Parameter &row) {
    if (row.kind == ir::ParameterKind::Constant)
      return row.constant;
    return row.state.item == ir::StateItem::FogParams ? ir::Vec4{1, 0, 1, 1} : ir::Vec4{};
  };
  EXPECT_EQ(ir::evaluate(arb, inputs).outputs[0], ir::evaluate(own, inputs).outputs[0]);
  EXPECT_EQ(ir::evaluate(arb, inputs).outputs[0], (ir::Vec4{0.5f, 0.375f, 0.25f, 0.5f}));
}

} // namespace
} // namespace arbiter::fp
