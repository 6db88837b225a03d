#include "fp_compiler/ir/builder.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/testing/pass_check.h"

namespace arbiter::fp::opt {
namespace {

using ir::AttributeKind;
using ir::Builder;
using ir::Opcode;

// MOV t, -c.wzyx; ADD o, -t.yyxx, c: the composed operand is c.zzww.
TEST(PropagateCopies, ComposesSwizzleAndNegate) {
  Builder b;
  const auto t = b.temporary();
  const auto c = b.local(0);
  b.op(Opcode::Mov, t, {-c.swz("wzyx")});
  b.op(Opcode::Add, b.color(), {-t.read().swz("yyxx"), c});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(propagateCopies, program));
  EXPECT_EQ(last(program), "ADD o0, p0.zzww, p0");
}

TEST(PropagateCopies, StopsAtAnOverwrittenSource) {
  Builder b;
  const auto t = b.temporary(), s = b.temporary();
  b.op(Opcode::Mul, s, {b.local(0), b.local(1)});
  b.op(Opcode::Mov, t, {s.read()});
  b.op(Opcode::Add, s.mask("y"), {b.local(0), b.local(1)});
  b.op(Opcode::Mov, b.color(), {t.read()});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(propagateCopies, program)) << "t.y is older than s.y";
}

TEST(PropagateCopies, SwapKeepsItsMeaning) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mul, t, {b.local(0), b.local(1)});
  b.op(Opcode::Mov, t.mask("xy"), {t.read().swz("yxzw")});
  b.op(Opcode::Mov, b.color(), {t.read()});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(propagateCopies, program));
}

TEST(PropagateCopies, SaturatingMovIsNoCopy) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mov, t.sat(), {b.local(0)});
  b.op(Opcode::Mov, b.color(), {t.read()});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(propagateCopies, program));
}

TEST(PropagateCopies, UnwrittenIsZeroAndJoinsAnyRegister) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mov, t.mask("xy"), {b.attribute(AttributeKind::ColorPrimary)});
  b.op(Opcode::Mov, b.color(), {-t.read()});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(propagateCopies, program));
  EXPECT_EQ(last(program), "MOV o0, a0.(-x,-y,-0,-0)");
}

TEST(PropagateCopies, TwoRegistersDoNotFitOneOperand) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mov, t.mask("x"), {b.local(0)});
  b.op(Opcode::Mov, t.mask("y"), {b.local(1)});
  b.op(Opcode::Mul, b.color().mask("x"), {t.read(), t.read()});
  b.op(Opcode::Mul, b.color().mask("xy"), {t.read(), t.read()});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(propagateCopies, program));
  EXPECT_EQ(ir::print(program.code[2]), "MUL o0.x, p0.xxxx, p0.xxxx");
  EXPECT_EQ(last(program), "MUL o0.xy, t0, t0");
}

TEST(PropagateCopies, ScalarsStayScalar) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mov, t, {-b.local(0)});
  b.op(Opcode::Rcp, b.color(), {t.read().swz("z")});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(propagateCopies, program));
  EXPECT_EQ(last(program), "RCP o0, -p0.z");
}

TEST(PropagateCopies, RandomPrograms) { runOnRandomPrograms(propagateCopies); }

} // namespace
} // namespace arbiter::fp::opt
