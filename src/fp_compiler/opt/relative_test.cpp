#include "fp_compiler/ir/builder.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/testing/pass_check.h"

/// Tests of the passes on relative operands.
namespace arbiter::fp::opt {
namespace {

using ir::AttributeKind;
using ir::Builder;
using ir::Opcode;
using ir::OutputKind;

struct Rows : Builder {
  Rows() : Builder(ir::Language::ArbVertex) {
    a = address();
    array = Builder::array({env(0), env(1), constant(1), constant(1)});
    position = result(OutputKind::Position);
  }
  ir::Source row(int offset = 0) const { return element(array, a, offset); }
  ir::Source scalar(const char *component) {
    return attribute(AttributeKind::Generic, 3).swz(component);
  }
  ir::Target a, position;
  int array = 0;
};

TEST(Relative, ARowIsSharedUntilTheAddressChanges) {
  Rows b;
  const auto one = b.temporary(), two = b.temporary(), three = b.temporary();
  const auto k = b.local(0);
  b.op(Opcode::Arl, b.a, {b.scalar("x")});
  b.op(Opcode::Mul, one, {b.row(1), k});
  b.op(Opcode::Mul, two, {b.row(1), k});
  b.op(Opcode::Arl, b.a, {b.scalar("y")});
  b.op(Opcode::Mul, three, {b.row(1), k});
  b.op(Opcode::Mad, b.position, {one.read(), two.read(), three.read()});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(shareExpressions, program));
  EXPECT_EQ(program.code[2].op, Opcode::Mov);
  EXPECT_EQ(program.code[4].op, Opcode::Mul) << "another row by now";
}

TEST(Relative, RowsThatDifferInOffsetOrArrayAreNotShared) {
  Rows b;
  const int other = b.Builder::array({b.env(4)});
  const auto one = b.temporary(), two = b.temporary(), three = b.temporary();
  const auto k = b.local(0);
  b.op(Opcode::Arl, b.a, {b.scalar("x")});
  b.op(Opcode::Mul, one, {b.row(0), k});
  b.op(Opcode::Mul, two, {b.row(1), k});
  b.op(Opcode::Mul, three, {Builder::element(other, b.a), k});
  b.op(Opcode::Mad, b.position, {one.read(), two.read(), three.read()});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(shareExpressions, program));
}

TEST(Relative, ACopyOfARowIsNotReadLaterByAnotherAddress) {
  Rows b;
  const auto t = b.temporary();
  b.op(Opcode::Arl, b.a, {b.scalar("x")});
  b.op(Opcode::Mov, t, {b.row()});
  b.op(Opcode::Arl, b.a, {b.scalar("y")});
  b.op(Opcode::Add, b.position, {t.read(), b.row()});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(propagateCopies, program));
}

TEST(Relative, AConstantRowIsNotAConstantOperand) {
  Rows b;
  // Parameter number `array` is a different register. The passes must not use its value.
  b.op(Opcode::Arl, b.a, {b.scalar("x")});
  b.op(Opcode::Mul, b.position, {b.row(), b.attribute(AttributeKind::Normal)});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(foldConstants, program));
  EXPECT_FALSE(runChecked(simplify, program));
}

TEST(Relative, ArlOfAConstantStaysAnArl) {
  Rows b;
  b.op(Opcode::Arl, b.a, {b.constant(1.5f).swz("x")});
  b.op(Opcode::Mov, b.position, {b.row()});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(foldConstants, program));
  EXPECT_EQ(program.code[0].op, Opcode::Arl);
}

TEST(Relative, ArlIsDeadWhereNoRowIsReadBeforeTheNext) {
  Rows b;
  b.op(Opcode::Arl, b.a, {b.scalar("x")});
  b.op(Opcode::Arl, b.a, {b.scalar("y")});
  b.op(Opcode::Mov, b.position, {b.row()});
  b.op(Opcode::Arl, b.a, {b.scalar("z")});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(removeDeadCode, program));
  ASSERT_EQ(program.code.size(), 2u);
  EXPECT_EQ(program.code[0].src[0].swizzle[0], ir::Select::Y);
}

TEST(Relative, WhatAnAddressIsLoadedFromIsLive) {
  Rows b;
  const auto t = b.temporary();
  b.op(Opcode::Mul, t.mask("x"), {b.local(0), b.local(1)});
  b.op(Opcode::Arl, b.a, {t.read().swz("x")});
  b.op(Opcode::Mov, b.position, {b.row()});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(removeDeadCode, program));
}

TEST(Relative, EveryVertexResultIsLive) {
  Rows b;
  b.options().positionInvariant = true;
  for (const OutputKind kind :
       {OutputKind::FrontPrimary, OutputKind::FrontSecondary, OutputKind::BackPrimary,
        OutputKind::BackSecondary, OutputKind::TexCoord})
    b.op(Opcode::Mov, b.result(kind, 0), {b.local(0)});
  b.op(Opcode::Mov, b.result(OutputKind::FogCoord).mask("x"), {b.local(0)});
  b.op(Opcode::Mov, b.result(OutputKind::PointSize).mask("xw"), {b.local(0)});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(removeDeadCode, program)) << "of a point size only x counts";
  EXPECT_EQ(program.code.size(), 7u);
  EXPECT_EQ(program.code.back().dst.mask, 1);
}

TEST(Relative, ARowAtAConstantAddressIsReadAsItIs) {
  Rows b;
  const auto one = b.temporary(), two = b.temporary();
  b.op(Opcode::Mov, one, {b.row(1)}); // addresses start at 0
  b.op(Opcode::Arl, b.a, {b.constant(2.75f).swz("x")});
  b.op(Opcode::Mul, two, {b.row(-1), b.row(2)}); // the second row is out of range
  b.op(Opcode::Arl, b.a, {b.scalar("x")});
  b.op(Opcode::Mad, b.position, {one.read(), two.read(), b.row(0)});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(resolveAddresses, program));
  EXPECT_FALSE(program.code[0].src[0].relative);
  EXPECT_EQ(program.code[0].src[0].index, program.arrays[0].rows[1]);
  EXPECT_EQ(program.code[2].src[0].index, program.arrays[0].rows[1]);
  EXPECT_EQ(program.code[2].src[1].swizzle[0], ir::Select::Zero);
  EXPECT_TRUE(program.code[4].src[2].relative);
}

} // namespace
} // namespace arbiter::fp::opt
