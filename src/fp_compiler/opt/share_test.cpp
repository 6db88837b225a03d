#include "fp_compiler/ir/builder.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/testing/pass_check.h"

namespace arbiter::fp::opt {
namespace {

using ir::Builder;
using ir::Opcode;
using ir::TexTarget;

TEST(ShareExpressions, OperandsMayChangePlaces) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mul, t, {b.local(0), -b.local(1)});
  b.op(Opcode::Mul, b.color(), {Builder(b).local(1), b.local(2)});
  ir::Program program = b.take();
  program.code[1].src = {program.code[0].src[1], program.code[0].src[0], {}};
  EXPECT_TRUE(runChecked(shareExpressions, program));
  EXPECT_EQ(last(program), "MOV o0, t0");
}

TEST(ShareExpressions, SubtractionIsOrdered) {
  Builder b;
  const auto t = b.temporary();
  const auto x = b.local(0), y = b.local(1);
  b.op(Opcode::Sub, t, {x, y});
  b.op(Opcode::Sub, b.color(), {y, x});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(shareExpressions, program));
}

TEST(ShareExpressions, ScalarsServeAnyMask) {
  Builder b;
  const auto t = b.temporary();
  const auto x = b.local(0).swz("y");
  b.op(Opcode::Rsq, t.mask("z"), {x});
  b.op(Opcode::Rsq, b.color().mask("xw"), {x});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(shareExpressions, program));
  EXPECT_EQ(last(program), "MOV o0.xw, t0.zzzz");
}

TEST(ShareExpressions, MindsOverwrittenOperandsAndResults) {
  Builder b;
  const auto t = b.temporary(), s = b.temporary();
  const auto x = b.local(0);
  b.op(Opcode::Mul, s, {x, x});
  b.op(Opcode::Add, t, {s.read(), x});
  b.op(Opcode::Add, s.mask("w"), {x, x});
  b.op(Opcode::Add, b.color().mask("w"), {s.read(), x}); // s.w differs
  b.op(Opcode::Add, b.color().mask("x"), {s.read(), x}); // a different mask gives a different key
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(shareExpressions, program));
  Builder c;
  const auto u = c.temporary();
  const auto y = c.local(0);
  c.op(Opcode::Mul, u, {y, y});
  c.op(Opcode::Mov, u.mask("x"), {y});
  c.op(Opcode::Mul, c.color(), {y, y}); // u.x is overwritten
  ir::Program overwritten = c.take();
  EXPECT_FALSE(runChecked(shareExpressions, overwritten));
}

TEST(ShareExpressions, SamplesOfOneUnit) {
  Builder b;
  const auto t = b.temporary();
  const auto at = b.attribute(ir::AttributeKind::TexCoord, 0);
  b.tex(Opcode::Tex, t, at, 0, TexTarget::Tex2D);
  b.tex(Opcode::Tex, b.color(), at, 1, TexTarget::Tex2D);
  b.tex(Opcode::Txb, b.color(), at, 0, TexTarget::Tex2D);
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(shareExpressions, program));
  program.code[1].unit = 0;
  EXPECT_TRUE(runChecked(shareExpressions, program));
  EXPECT_EQ(ir::print(program.code[1]), "MOV o0, t0");
}

TEST(ShareExpressions, RandomPrograms) {
  // Random programs seldom contain equal instructions.
  runOnRandomPrograms(shareExpressions, 300, [](ir::Program &program) {
    std::vector<ir::Instruction> twice;
    for (const ir::Instruction &instruction : program.code)
      twice.insert(twice.end(), {instruction, instruction});
    program.code = twice;
  });
}

} // namespace
} // namespace arbiter::fp::opt
