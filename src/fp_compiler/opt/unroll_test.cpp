#include <algorithm>

#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/testing/pass_check.h"
#include "fp_compiler/testing/nv_program.h"

namespace arbiter::fp::opt {
namespace {

ir::Program programOf(const std::string &statements) {
  return testing::nvFragmentProgram("TEMP r;\nMOV r, fragment.color;\n" + statements +
                                    "\nMOV result.color, r;");
}

int unrolledAdditions(const std::string &statements) {
  ir::Program program = programOf(statements);
  (void)runChecked(unrollLoops, program, statements);
  return countWithoutLoops(program, ir::Opcode::Add);
}

TEST(UnrollLoops, ConstantCounts) {
  EXPECT_EQ(unrolledAdditions("REP 4; ADD r, r, r; ENDREP;"), 4);
  EXPECT_EQ(unrolledAdditions("REP 2.9; ADD r, r, r; ENDREP;"), 2);
  EXPECT_EQ(unrolledAdditions("REP 1; ADD r, r, r; ENDREP;"), 1);
  EXPECT_EQ(unrolledAdditions("REP 0.5; ADD r, r, r; ENDREP;"), 0);
  EXPECT_EQ(unrolledAdditions("REP 0; REP 3; ADD r, r, r; ENDREP; ENDREP;"), 0);
  EXPECT_EQ(unrolledAdditions("REP 3; ADD r, r, 1.0; REP 2; ADD r, r, r; ENDREP; ENDREP;"), 3 + 6);
  EXPECT_EQ(unrolledAdditions("ADD r, r, r; REP 2; ENDREP;"), 1);
}

TEST(UnrollLoops, WhatStays) {
  EXPECT_EQ(unrolledAdditions("REP 4; ADDC r, r, r; BRK (GT.x); ENDREP;"), -1);
  EXPECT_EQ(unrolledAdditions("REP program.local[0].x; ADD r, r, r; ENDREP;"), -1);
  EXPECT_EQ(unrolledAdditions("REP 2000; ADD r, r, r; ENDREP;"), -1) << "too much code";
  const std::string half = "REP 200; ADD r, r, 1.0; ADD r, r, r; ADD r, r, 1.0; ENDREP;";
  EXPECT_EQ(unrolledAdditions(half), 600);
  EXPECT_EQ(unrolledAdditions(half + half), -1) << "too much together";
  // Together the loops reach the cap on iterations, in the middle of the second one.
  EXPECT_EQ(unrolledAdditions("REP 250; REP 255; REP 2; ADD r, r, 1.0; ENDREP; ENDREP; ENDREP;"),
            -1);
}

TEST(UnrollLoops, ALoopThatBreaksHoldsOneThatDoesNot) {
  ir::Program program =
      programOf("REP 5; REP 2; ADD r, r, 0.25; ENDREP; SUBC r.w, r, 1.0; BRK (GT.w); ENDREP;");
  EXPECT_TRUE(runChecked(unrollLoops, program));
  const auto count = [&](ir::Opcode op) {
    return std::count_if(program.code.begin(), program.code.end(),
                         [op](const auto &instruction) { return instruction.op == op; });
  };
  EXPECT_EQ(count(ir::Opcode::Rep), 1);
  EXPECT_EQ(count(ir::Opcode::Add), 2);
}

TEST(UnrollLoops, AnInputThatALoopChoosesIsReadAsItIs) {
  ir::Program program =
      programOf("LOOP {3, 1, 2}; ADD r, r, fragment.texcoord[A0.x + 1]; ENDLOOP;");
  run(program);
  EXPECT_FALSE(ir::hasLoops(program));
  EXPECT_LE(program.code.size(), 4u) << ir::print(program);
}

} // namespace
} // namespace arbiter::fp::opt
