#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/testing/pass_check.h"
#include "fp_compiler/testing/nv_program.h"

namespace arbiter::fp::opt {
namespace {

constexpr char kBegin[] = "TEMP r, s, t;\nMOV r, fragment.color;\n";

/// Returns the number of instructions with one opcode that remain, or -1 if a loop remains.
int left(ir::Opcode op, const std::string &statements) {
  ir::Program program = testing::nvFragmentProgram(kBegin + statements + "\nMOV result.color, r;");
  const bool followed = runChecked(followLoops, program, statements);
  EXPECT_EQ(followed, !ir::hasLoops(program)) << statements;
  return countWithoutLoops(program, op);
}

int followedAdditions(const std::string &statements) { return left(ir::Opcode::Add, statements); }

TEST(FollowLoops, WhatConstantsDecide) {
  EXPECT_EQ(followedAdditions("REP 4; ADD r, r, r; ENDREP;"), 4);
  // The count comes from a condition, and so does the exit.
  EXPECT_EQ(followedAdditions("MOVC t.x, 2.0; IF GT.x; REP 4; ADD r, r, r; ENDREP; ENDIF;"), 4);
  EXPECT_EQ(followedAdditions("MOVC t.x, 2.0; IF LT.x; REP 4; ADD r, r, r; ENDREP; ENDIF;"), 0);
  EXPECT_EQ(followedAdditions(
                "MOV t, 5.0; REP 255; ADD r, r, r; SUBC t.x, t.x, 1.0; BRK (LE.x); ENDREP;"),
            5);
  EXPECT_EQ(
      followedAdditions("REP 3; REP 9; ADD r, r, r; BRK (TR); ENDREP; ADD r, r, 1.0; ENDREP;"), 6);
}

TEST(FollowLoops, WhatValuesDecideIsSelected) {
  EXPECT_EQ(followedAdditions("REP 3; ADDC r.xyz, r, r; BRK (GT.x); ENDREP;"), 3);
  EXPECT_EQ(left(ir::Opcode::Kil, "REP 3; ADDC r, r, r; BRK (GT.x); KIL r; ENDREP;"), 3);
  EXPECT_EQ(followedAdditions("REP 3; ADDC r, r, r; BRK (GT.y); REP 2; MULC s, r, 2.0; BRK (GT.z); "
                              "ADD r, s, 0.5; ENDREP; ENDREP;"),
            9);
  // A sample that needs no neighbours may follow a BRK.
  EXPECT_EQ(
      followedAdditions("REP 2; ADDC r, r, r; BRK (GT.x); TXL s, r, texture[0], 2D; ADD r, r, s; "
                        "ENDREP;"),
      4);
}

TEST(FollowLoops, WhatStays) {
  EXPECT_EQ(followedAdditions("REP program.local[0].x; ADD r, r, r; ENDREP;"), -1);
  EXPECT_EQ(followedAdditions("REP 255; ADDC r, r, r; BRK (GT.x); ENDREP;"), -1)
      << "mostly left early";
  EXPECT_EQ(followedAdditions("REP 255; REP 255; ADD r, r, r; ENDREP; ENDREP;"), -1)
      << "too much code";
  EXPECT_EQ(followedAdditions("REP 255; REP 255; ENDREP; ENDREP;"), -1) << "too many steps";
  EXPECT_EQ(followedAdditions("REP 2; ADDC r, r, r; BRK (GT.x); TEX s, r, texture[0], 2D; ENDREP;"),
            -1);
  EXPECT_EQ(followedAdditions("REP 2; ADDC r, r, r; BRK (GT.x); DDX s, r; ENDREP;"), -1);
}

TEST(FollowLoops, ALoopOfJumpsBecomesStraight) {
  CompileOptions options;
  options.policy = LimitPolicy::Report;
  options.limits.nvOptions = 2;
  options.limits.envParameters = options.limits.localParameters = 32;
  const std::string text = "!!ARBvp1.0\nOPTION NV_vertex_program2;\nTEMP k, r;\nADDRESS a;\n"
                           "PARAM c[8] = { program.env[0..7] };\nMOV k.x, 3.0;\nagain:\n"
                           "ARL a.x, k.x;\nADD r, r, c[a.x + 2];\nADDC k.x, k.x, -1.0;\n"
                           "BRA again (GE.x);\nMOV result.position, r;\nEND\n";
  CheckResult result = checkProgram(ir::Language::ArbVertex, text, options);
  ASSERT_TRUE(result.ok()) << result.errorString(text);
  ir::Program program = std::move(*result.program);
  EXPECT_TRUE(runChecked(followLoops, program));
  run(program);
  ASSERT_FALSE(ir::hasLoops(program));
  // Four rows and the result remain, none of them with relative addressing.
  EXPECT_LE(program.code.size(), 9u) << ir::print(program);
  for (const ir::Instruction &instruction : program.code)
    for (const ir::Operand &operand : instruction.src)
      EXPECT_FALSE(operand.relative);
}

} // namespace
} // namespace arbiter::fp::opt
