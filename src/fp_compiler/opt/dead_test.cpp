#include "fp_compiler/ir/builder.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/testing/pass_check.h"

namespace arbiter::fp::opt {
namespace {

using ir::Builder;
using ir::Opcode;
using ir::TexTarget;

TEST(RemoveDeadCode, ShrinksMasksToWhatIsRead) {
  Builder b;
  const auto t = b.temporary(), s = b.temporary();
  b.op(Opcode::Mul, t, {b.local(0), b.local(1)});
  b.op(Opcode::Mul, s, {b.local(0), b.local(1)});
  b.op(Opcode::Dp3, b.color(), {t.read().swz("xxyw"), b.local(1)});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(removeDeadCode, program));
  ASSERT_EQ(program.code.size(), 2u);
  EXPECT_EQ(ir::print(program.code[0]), "MUL t0.xy, p0, p1");
}

TEST(RemoveDeadCode, FollowsChainsBackwards) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mul, t, {b.local(0), b.local(1)});
  b.tex(Opcode::Tex, t, t.read(), 0, TexTarget::Tex2D);
  b.op(Opcode::Mul, t, {b.local(0), b.local(1)});
  b.op(Opcode::Mov, b.color(), {t.read()});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(removeDeadCode, program));
  EXPECT_EQ(program.code.size(), 2u);
}

TEST(RemoveDeadCode, KillsStayAndKeepTheirOperands) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mul, t, {b.local(0), b.local(1)});
  b.kil(t.read().swz("x"));
  b.op(Opcode::Mov, b.color(), {b.local(0)});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(removeDeadCode, program));
  EXPECT_EQ(ir::print(program.code[0]), "MUL t0.x, p0, p1");
  EXPECT_EQ(program.code.size(), 3u);
}

TEST(RemoveDeadCode, OverwrittenOutputsAndUnusedDepth) {
  Builder b;
  b.op(Opcode::Mov, b.color(), {b.local(0)});
  b.op(Opcode::Mov, b.color().mask("xyz"), {b.local(1)});
  b.op(Opcode::Mov, b.depth(), {b.local(2)});
  b.op(Opcode::Mov, b.depth().mask("xy"), {b.local(3)});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(removeDeadCode, program));
  ASSERT_EQ(program.code.size(), 3u);
  EXPECT_EQ(ir::print(program.code[0]), "MOV o0.w, p0");
  EXPECT_EQ(ir::print(program.code[2]), "MOV o1.z, p2");
}

TEST(RemoveDeadCode, RandomPrograms) { runOnRandomPrograms(removeDeadCode); }

} // namespace
} // namespace arbiter::fp::opt
