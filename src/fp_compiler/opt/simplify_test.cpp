#include <limits>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/testing/pass_check.h"
#include "fp_compiler/testing/nv_program.h"

namespace arbiter::fp::opt {
namespace {

using ir::Builder;
using ir::Opcode;
using ir::Source;

/// Returns the instruction that the pass makes of `op color.xyz, sources`, or "" if none is left.
std::string simplified(Opcode op, std::initializer_list<Source> sources, Builder b) {
  b.op(op, b.color().mask("xyz"), sources);
  ir::Program program = b.take();
  runChecked(simplify, program);
  return program.code.empty() ? "" : ir::print(program.code.back());
}

TEST(Simplify, Identities) {
  Builder b;
  const Source x = b.local(0), y = b.local(1);
  // Components of a constant outside the mask may have any value.
  const Source one = b.constant(1, 1, 1, 7), zero = b.constant(0), minusZero = b.constant(-0.0f);
  EXPECT_EQ(simplified(Opcode::Mul, {x, one}, b), "MOV o0.xyz, p0");
  EXPECT_EQ(simplified(Opcode::Mul, {-one, -x}, b), "MOV o0.xyz, p0");
  EXPECT_EQ(simplified(Opcode::Mul, {-one, x}, b), "MOV o0.xyz, -p0");
  EXPECT_EQ(simplified(Opcode::Sub, {x, zero}, b), "MOV o0.xyz, p0");
  EXPECT_EQ(simplified(Opcode::Add, {x, minusZero}, b), "MOV o0.xyz, p0");
  EXPECT_EQ(simplified(Opcode::Add, {-zero, x}, b), "MOV o0.xyz, p0");
  EXPECT_EQ(simplified(Opcode::Mad, {x, one, y}, b), "ADD o0.xyz, p0, p1");
  EXPECT_EQ(simplified(Opcode::Mad, {-one, x, y}, b), "SUB o0.xyz, p1, p0");
  EXPECT_EQ(simplified(Opcode::Mad, {x, y, -zero}, b), "MUL o0.xyz, p0, p1");
  EXPECT_EQ(simplified(Opcode::Max, {x, x}, b), "MOV o0.xyz, p0");
  EXPECT_EQ(simplified(Opcode::Abs, {-x}, b), "ABS o0.xyz, p0");
  EXPECT_EQ(simplified(Opcode::Rsq, {-x.swz("y")}, b), "RSQ o0.xyz, p0.y");
  EXPECT_EQ(simplified(Opcode::Pow, {x.swz("y"), zero.swz("x")}, b), "MOV o0.xyz, p3.(1,1,1,1)");
  EXPECT_EQ(simplified(Opcode::Swz, {x.swz("0y1x")}, b), "MOV o0.xyz, p0.(0,y,1,x)");
}

TEST(Simplify, ConditionsThatAreKnown) {
  Builder b;
  const Source x = b.local(0), y = b.local(1), below = b.constant(-1);
  const Source minusZero = b.constant(-0.0f), mixed = b.constant(-1, -1, 1, 1);
  EXPECT_EQ(simplified(Opcode::Cmp, {below, x, y}, b), "MOV o0.xyz, p0");
  EXPECT_EQ(simplified(Opcode::Cmp, {minusZero, x, y}, b), "MOV o0.xyz, p1");
  EXPECT_EQ(simplified(Opcode::Cmp, {mixed, x, y}, b), "CMP o0.xyz, p4, p0, p1");
  EXPECT_EQ(simplified(Opcode::Cmp, {y, x, x}, b), "MOV o0.xyz, p0");
}

TEST(Simplify, AConstantIsWhatTheModeReads) {
  const auto after = [](Opcode op, float constant, Numerics numerics) {
    Builder b;
    const Source c = b.constant(constant), x = b.local(0), y = b.local(1);
    if (op == Opcode::Cmp)
      b.op(op, b.color(), {c, x, y});
    else
      b.op(op, b.color(), {x, c});
    ir::Program program = b.take();
    runChecked(simplify, program, "", numerics);
    return ir::print(program.code[0]);
  };
  // The value is negative as a single, but zero as a 24-bit float.
  EXPECT_EQ(after(Opcode::Cmp, -0x1p-63f, Numerics::Host), "MOV o0, p1");
  EXPECT_EQ(after(Opcode::Cmp, -0x1p-63f, Numerics::Fp24), "MOV o0, p2");
  EXPECT_EQ(after(Opcode::Cmp, -0x1p-62f, Numerics::Fp24), "MOV o0, p1");
  EXPECT_EQ(after(Opcode::Mul, 0x1.000002p0f, Numerics::Legacy), "MUL o0, p1, p0");
  EXPECT_EQ(after(Opcode::Mul, 0x1.000002p0f, Numerics::Fp24), "MOV o0, p1") << "truncated to 1";
}

TEST(Simplify, LeavesWhatIsNotAnIdentity) {
  Builder b;
  const Source x = b.local(0), zero = b.constant(0);
  EXPECT_EQ(simplified(Opcode::Add, {x, zero}, b), "ADD o0.xyz, p0, p1") << "-0 + 0 is 0";
  EXPECT_EQ(simplified(Opcode::Mul, {x, zero}, b), "MUL o0.xyz, p0, p1") << "NaN * 0 is NaN";
  EXPECT_EQ(simplified(Opcode::Sub, {x, x}, b), "SUB o0.xyz, p0, p0") << "inf - inf is NaN";
  EXPECT_EQ(simplified(Opcode::Max, {x, -x}, b), "MAX o0.xyz, p0, -p0");
}

TEST(Simplify, RemovesIdleMovesAndHarmlessKills) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mul, t, {b.local(0), b.local(1)});
  b.op(Opcode::Mov, t.mask("xz"), {t.read()});
  b.kil(b.constant(0, 1, -0.0f, 2));
  b.kil(b.constant(0, 1, -1, 2));
  b.op(Opcode::Mov, b.color(), {t.read()});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(simplify, program));
  ASSERT_EQ(program.code.size(), 3u);
  EXPECT_EQ(program.code[1].op, Opcode::Kil);
}

/// Returns what the pass makes of a multiplication by one under NVIDIA's options.
std::string product(const std::string &operand, Numerics numerics = Numerics::Host) {
  ir::Program program =
      testing::nvFragmentProgram("TEMP r, s;\nPK2H r, fragment.color;\nMOV s.y, r;\nMUL s.x, " +
                                 operand + ", 1.0;\nUP2H result.color, s.x;");
  runChecked(simplify, program, operand, numerics);
  return std::string(ir::info(program.code[2].op).mnemonic);
}

TEST(Simplify, ACopyOfBitsIsNoProduct) {
  EXPECT_EQ(product("fragment.color"), "MOV");
  EXPECT_EQ(product("program.local[0]"), "MUL");
  EXPECT_EQ(product("program.local[0]", Numerics::Fp24), "MOV") << "loaded as numbers";
  EXPECT_EQ(product("r"), "MUL");
  EXPECT_EQ(product("s.y"), "MUL");
  EXPECT_EQ(product("{1e-40, 0.0, 0.0, 0.0}"), "MUL");
  EXPECT_EQ(product("{0.25, 0.0, 0.0, 0.0}"), "MOV");
}

TEST(Simplify, RandomPrograms) { runOnRandomPrograms(simplify); }

} // namespace
} // namespace arbiter::fp::opt
