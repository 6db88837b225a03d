#include <chrono>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/testing/pass_check.h"

namespace arbiter::fp::opt {
namespace {

using ir::Builder;
using ir::Opcode;

bool runAll(ir::Program &program, Numerics numerics) {
  const std::string before = ir::print(program);
  run(program, numerics);
  return ir::print(program) != before;
}

TEST(Pipeline, PassesFeedEachOther) {
  Builder b;
  const auto t = b.temporary(), s = b.temporary();
  b.op(Opcode::Swz, t, {b.constant(2, 4, 8, 16).swz("1xyz")});
  b.op(Opcode::Rcp, s, {t.read().swz("y")});  // 1/2
  b.op(Opcode::Add, s, {s.read(), s.read()}); // 1
  b.op(Opcode::Mul, t, {b.local(0), s.read()});
  b.op(Opcode::Mov, b.color(), {t.read()});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(runAll, program));
  ASSERT_EQ(program.code.size(), 1u);
  EXPECT_EQ(ir::print(program.code[0]), "MOV o0, p1");
}

TEST(Pipeline, RandomPrograms) { runOnRandomPrograms(runAll, 1200); }

/// Optimising a few thousand instructions takes milliseconds. Four times the program must not take
/// much more than four times as long.
TEST(Pipeline, IsAboutLinear) {
  const auto seconds = [](int instructions) {
    testing::RandomOptions options;
    options.minInstructions = options.maxInstructions = instructions;
    double best = 1e9;
    for (int i = 0; i < 3; ++i) {
      ir::Program program = testing::randomProgram(7, options);
      const auto start = std::chrono::steady_clock::now();
      run(program);
      best = std::min(
          best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
  };
  const double small = seconds(2000), large = seconds(8000);
  EXPECT_LT(large, 16 * small + 0.02) << small << " s, " << large << " s";
  EXPECT_LT(small, 1.0) << "a few milliseconds unless under a sanitizer";
}

/// MOV r, 0 and additions of constants to r, as in piglit's fp-long-alu. Each round folds one more,
/// so that unbounded rounds would take quadratic time.
TEST(Pipeline, ALongChainOfConstantsIsAboutLinear) {
  const auto seconds = [](int additions) {
    Builder b;
    const auto r = b.temporary();
    b.op(Opcode::Mov, r, {b.constant(0, 0, 0, 0)});
    for (int i = 0; i < additions; ++i)
      b.op(Opcode::Add, r, {r.read().swz("wxyz"), b.constant(0.0625f, 0, 0, 0)});
    b.op(Opcode::Mov, b.color(), {r.read()});
    ir::Program program = b.take();
    const auto start = std::chrono::steady_clock::now();
    run(program);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const double small = seconds(1000), large = seconds(8000);
  EXPECT_LT(large, 32 * small + 0.02) << small << " s, " << large << " s";
}

} // namespace
} // namespace arbiter::fp::opt
