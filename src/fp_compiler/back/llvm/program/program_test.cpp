// Tests the rules of the walk one by one.

#include <gtest/gtest.h>
#include <limits>

#include "fp_compiler/back/llvm/testing/machine.h"
#include "fp_compiler/ir/builder.h"

namespace arbiter::fp::llvm_back {
namespace {

using ir::Opcode;
using ir::Vec4;

/// Runs one lane of a program on this processor.
TestMachine::Result lane(const ir::Program &program, const TestMachine::Attributes &attributes,
                         const std::vector<Vec4> &parameters = {}) {
  const TestMachine machine(program, Numerics::Host, "");
  EXPECT_EQ(machine.reason(), "");
  return machine.run({attributes}, parameters)[0];
}

constexpr Vec4 kNumbers = {1, 2, 3, 4};

TEST(Program, OperandsAreReadBeforeAnythingIsWritten) {
  ir::Builder b;
  const ir::Target t = b.temporary();
  b.op(Opcode::Mov, t, {b.attribute(ir::AttributeKind::TexCoord)});
  b.op(Opcode::Mov, t.mask("xy"), {t.read().swz("yxzw")});
  b.op(Opcode::Mov, b.color(), {t.read()});
  EXPECT_EQ(lane(b.program(), {kNumbers}).outputs[0], (Vec4{2, 1, 3, 4}));
}

TEST(Program, WhatIsNotWrittenIsZero) {
  ir::Builder b;
  const ir::Target t = b.temporary();
  b.op(Opcode::Mov, t.mask("y"), {b.attribute(ir::AttributeKind::TexCoord)});
  b.op(Opcode::Add, b.color().mask("xyz"), {t.read(), b.constant(0.5f)});
  EXPECT_EQ(lane(b.program(), {kNumbers}).outputs[0], (Vec4{0.5f, 2.5f, 0.5f, 0}));
}

TEST(Program, KilDiscardsBelowZeroOnly) {
  ir::Builder b;
  b.kil(b.attribute(ir::AttributeKind::TexCoord));
  b.op(Opcode::Mov, b.color(), {b.constant(1)});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(lane(b.program(), {kNumbers}).killed);
  EXPECT_FALSE(lane(b.program(), {{-0.0f, nan, 0, 1}}).killed);
  EXPECT_FALSE(lane(b.program(), {{-1e-40f, 0, 0, 1}}).killed);
  EXPECT_TRUE(lane(b.program(), {{1, 1, 1, -1e-30f}}).killed);
}

TEST(Program, SaturationMakesZeroOfNan) {
  ir::Builder b;
  b.op(Opcode::Mov, b.color().sat(), {b.attribute(ir::AttributeKind::TexCoord)});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(lane(b.program(), {{nan, -1, 0.25f, 7}}).outputs[0], (Vec4{0, 0, 0.25f, 1}));
}

TEST(Program, TexturesSeeTheirCoordinates) {
  ir::Builder b;
  const ir::Source at = b.attribute(ir::AttributeKind::TexCoord);
  b.tex(Opcode::Txp, b.color(0), at, 0, ir::TexTarget::Tex3D);
  b.tex(Opcode::Txb, b.color(1), at.swz("wzyx"), 1, ir::TexTarget::Tex2D);
  b.tex(Opcode::Tex, b.color(2).mask("xw"), -at, 2, ir::TexTarget::Tex1D);
  const auto outputs = lane(b.program(), {{1, 2, 3, 2}}).outputs;
  EXPECT_EQ(outputs[0], (Vec4{0.5f, 1, 1.5f, 0}));
  EXPECT_EQ(outputs[1], (Vec4{2, 3, 0, 1}));
  EXPECT_EQ(outputs[2], (Vec4{-1, 0, 0, 0}));
}

} // namespace
} // namespace arbiter::fp::llvm_back
