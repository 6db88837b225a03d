#include "fp_compiler/ir/builder.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/pass_check.h"

namespace arbiter::fp::opt {
namespace {

using ir::Builder;
using ir::Opcode;

TEST(FoldConstants, ComputesWithSwizzleSignMaskAndSaturate) {
  Builder b;
  b.op(Opcode::Mad, b.color().mask("xz").sat(),
       {b.constant(1, 2, 3, 4).swz("wzyx"), b.constant(0.125f), -b.constant(0.25f)});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(foldConstants, program));
  EXPECT_EQ(ir::print(program.code[0]), "MOV o0.xz, p3");
  EXPECT_EQ(program.parameters[3].constant, (ir::Vec4{0.25f, 0.25f, 0, 0.25f}));
}

TEST(FoldConstants, LooksOnlyAtWhatIsRead) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mov, t, {b.local(0)});
  b.op(Opcode::Dp3, b.color(), {b.constant(1, 2, 3, 4), t.read().swz("0111")});
  b.op(Opcode::Dph, b.color(), {b.constant(1, 2, 3, 4), t.read().swz("011x")});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(foldConstants, program));
  EXPECT_EQ(program.code[1].op, Opcode::Mov) << "DP3 does not read w";
  EXPECT_EQ(program.code[2].op, Opcode::Dph) << "DPH reads it";
}

TEST(FoldConstants, SharesRows) {
  Builder b;
  b.op(Opcode::Add, b.color().mask("x"), {b.constant(1), b.constant(2)});
  b.op(Opcode::Mul, b.color().mask("y"), {b.constant(1), b.constant(3)});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(foldConstants, program));
  EXPECT_EQ(program.parameters.size(), 4u) << "3 was there already";
}

TEST(FoldConstants, LeavesInfinityToTheHost) {
  Builder b;
  b.op(Opcode::Rcp, b.color(), {b.constant(0).swz("x")});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(foldConstants, program));
}

TEST(FoldConstants, LeavesMovesAlone) {
  Builder b;
  b.op(Opcode::Mov, b.color(), {-b.constant(1, 2, 3, 4).swz("wzyx")});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(foldConstants, program));
}

TEST(FoldConstants, RandomPrograms) { runOnRandomPrograms(foldConstants); }

} // namespace
} // namespace arbiter::fp::opt
