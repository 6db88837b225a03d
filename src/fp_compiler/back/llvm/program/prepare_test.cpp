// Tests the shape of a program, which must be known before there is a key.

#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/program/prepare.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/validate.h"

namespace arbiter::fp::llvm_back {
namespace {

using ir::AttributeKind;
using ir::Opcode;
using ir::TexTarget;

jit::FragmentShape shapeOf(ir::Builder &b) {
  EXPECT_EQ(ir::validate(b.program()), std::vector<std::string>{});
  return PreparedFragment(b.take(), Numerics::Host).shape();
}

TEST(Prepare, ListsWhatIsReadOnly) {
  ir::Builder b;
  const ir::Target unused = b.temporary();
  b.op(Opcode::Mov, unused, {b.attribute(AttributeKind::ColorSecondary)});
  b.tex(Opcode::Tex, unused, b.attribute(AttributeKind::TexCoord, 5), 5, TexTarget::Tex2D);
  const ir::Target t = b.temporary();
  b.tex(Opcode::Tex, t, b.attribute(AttributeKind::TexCoord, 2), 3, TexTarget::Tex2D);
  b.op(Opcode::Mul, b.color(), {t.read(), b.attribute(AttributeKind::Position).swz("z")});
  const jit::FragmentShape shape = shapeOf(b);
  ASSERT_EQ(shape.inputs.size(), 1u); // the position is no input
  EXPECT_EQ(shape.inputs[0].attribute, (ir::Attribute{AttributeKind::TexCoord, 2}));
  EXPECT_EQ(shape.inputs[0].components, 3);
  ASSERT_EQ(shape.samplers.size(), 1u);
  EXPECT_EQ(shape.samplers[0].unit, 3);
  EXPECT_EQ(shape.samplers[0].target, TexTarget::Tex2D);
  EXPECT_EQ(shape.colorOutputs, 1);
  EXPECT_FALSE(shape.writesDepth);
  EXPECT_FALSE(shape.kills);
  EXPECT_EQ(shape.needsQuads, 0u);
}

TEST(Prepare, OptionsAddInputs) {
  ir::Builder b;
  b.op(Opcode::Mov, b.color(), {b.attribute(AttributeKind::FogCoord).swz("y")});
  b.op(Opcode::Mov, b.depth().mask("z"), {b.attribute(AttributeKind::FogCoord).swz("y")});
  b.kil(b.attribute(AttributeKind::FogCoord).swz("y"));
  b.options().fog = ir::FogMode::Linear;
  b.options().colorSum = true;
  const jit::FragmentShape shape = shapeOf(b);
  ASSERT_EQ(shape.inputs.size(), 2u);
  EXPECT_EQ(shape.inputs[0].attribute.kind, AttributeKind::FogCoord);
  EXPECT_EQ(shape.inputs[0].components, 3);
  EXPECT_EQ(shape.inputs[1].attribute.kind, AttributeKind::ColorSecondary);
  EXPECT_EQ(shape.inputs[1].components, 7);
  EXPECT_TRUE(shape.writesDepth);
  EXPECT_TRUE(shape.kills);
}

/// Returns needsQuads for a sample whose coordinate `write` computes from an attribute.
template <typename F> bool needsQuads(F write, TexTarget target, Opcode op = Opcode::Tex) {
  ir::Builder b;
  b.options().shadow = true;
  const ir::Target t = b.temporary();
  write(b, t, b.attribute(AttributeKind::TexCoord));
  b.tex(op, b.color(), t.read(), 0, target);
  return shapeOf(b).needsQuads != 0;
}

TEST(Prepare, AffineCoordinatesNeedNoQuads) {
  const auto scaled = [](ir::Builder &b, const ir::Target &t, const ir::Source &at) {
    b.op(Opcode::Mad, t, {at, b.local(0), b.local(1)});
  };
  const auto product = [](ir::Builder &b, const ir::Target &t, const ir::Source &at) {
    b.op(Opcode::Mul, t, {at, at.swz("yxzw")});
  };
  const auto turned = [](ir::Builder &b, const ir::Target &t, const ir::Source &at) {
    b.op(Opcode::Dp4, t.mask("x"), {at, b.local(0)});
    b.op(Opcode::Dp3, t.mask("y"), {b.local(1), at});
  };
  const auto saturated = [](ir::Builder &b, const ir::Target &t, const ir::Source &at) {
    b.op(Opcode::Mov, t.sat(), {at});
  };
  const auto sampled = [](ir::Builder &b, const ir::Target &t, const ir::Source &at) {
    b.tex(Opcode::Tex, t, at, 1, TexTarget::Tex2D);
    b.op(Opcode::Add, t, {t.read(), at});
  };
  const auto oneComponent = [](ir::Builder &b, const ir::Target &t, const ir::Source &at) {
    b.op(Opcode::Mov, t, {at});
    b.op(Opcode::Mul, t.mask("z"), {at.swz("x"), at.swz("x")});
  };
  const auto projected = [](ir::Builder &b, const ir::Target &t, const ir::Source &at) {
    b.op(Opcode::Mov, t, {at});
    b.op(Opcode::Mov, t.mask("w"), {b.local(0)});
  };
  EXPECT_FALSE(needsQuads(scaled, TexTarget::Tex2D));
  EXPECT_TRUE(needsQuads(scaled, TexTarget::Cube));
  EXPECT_TRUE(needsQuads(product, TexTarget::Tex2D));
  EXPECT_FALSE(needsQuads(turned, TexTarget::Tex2D));
  EXPECT_TRUE(needsQuads(saturated, TexTarget::Tex2D));
  EXPECT_TRUE(needsQuads(sampled, TexTarget::Tex2D));
  EXPECT_FALSE(needsQuads(oneComponent, TexTarget::Tex2D));
  EXPECT_FALSE(needsQuads(oneComponent, TexTarget::Shadow2D)); // z is the reference
  EXPECT_TRUE(needsQuads(oneComponent, TexTarget::Tex3D));
  EXPECT_FALSE(needsQuads(projected, TexTarget::Tex2D, Opcode::Txp));
  EXPECT_TRUE(needsQuads(scaled, TexTarget::Tex2D, Opcode::Txp));
}

TEST(Prepare, OfNvidiasOptions) {
  const auto shape = [](Opcode op) {
    ir::Builder b;
    b.options().nv = ir::NvOption::Second;
    const ir::Source at = b.attribute(AttributeKind::TexCoord),
                     face = b.attribute(AttributeKind::Facing);
    const ir::Target t = b.temporary();
    b.op(Opcode::Mul, t, {at, face});
    if (op == Opcode::Ddx)
      b.op(op, t, {t.read()});
    else
      b.tex(op, t, t.read(), 0, TexTarget::Tex2D);
    b.op(Opcode::Mov, b.color(), {t.read()});
    return shapeOf(b);
  };
  EXPECT_EQ(shape(Opcode::Tex).needsQuads, 1u); // the facing is not a plane
  EXPECT_EQ(shape(Opcode::Txl).needsQuads, 0u); // the instruction gives the level
  EXPECT_FALSE(shape(Opcode::Txl).derivatives);
  EXPECT_TRUE(shape(Opcode::Ddx).derivatives);
  EXPECT_EQ(shape(Opcode::Ddx).inputs.size(), 1u); // the facing is no input
}

} // namespace
} // namespace arbiter::fp::llvm_back
