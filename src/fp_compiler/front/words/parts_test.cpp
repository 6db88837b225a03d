// What is said of a statement that lacks a part or its semicolon.
#include "fp_compiler/front/words/parts.h"

#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"

namespace arbiter::fp {
namespace {

using testing_support::check;
using testing_support::generous;

struct Missing {
  const char *text; ///< @ is where the error is
  const char *message;
  const char *hint;
};

void names(std::initializer_list<Missing> rows) {
  CompileOptions options = generous();
  options.limits.nvOptions = 2;
  options.limits.nvVertexProgram = 1;
  options.limits.generalCombiners = 8;
  for (const Missing &row : rows) {
    std::string text = row.text;
    const std::size_t at = text.find('@');
    text.erase(at, 1);
    const CheckResult result = check(text, options);
    ASSERT_FALSE(result.diagnostics.empty()) << text;
    const Diagnostic &first = result.diagnostics.front();
    EXPECT_EQ(first.message, row.message) << text;
    EXPECT_EQ(first.hint, row.hint) << text;
    EXPECT_EQ(first.span.begin, at) << text;
    EXPECT_STREQ(first.id, "syntax") << text;
  }
}

TEST(Parts, ThatAreMissingAreNamed) {
  names({{"!!ARBfp1.0\nTEMP r;\nTEX r, r, texture[0]@;\nEND",
          "the texture target of TEX is missing", "write TEX r, r, texture[0], 2D;"},
         {"!!ARBfp1.0\nTEMP r;\nTEX r, r@;\nEND", "the texture image unit of TEX is missing",
          "write TEX r, r, texture[0], 2D;"},
         {"!!ARBfp1.0\nTEMP r;\nTEX r@;\nEND", "the coordinate of TEX is missing",
          "write TEX r, coord, texture[0], 2D;"},
         {"!!ARBfp1.0\nTEMP r;\nMAD r, r, r@;\nEND", "the third operand of MAD is missing",
          "write MAD r, r, r, third;"},
         {"!!ARBfp1.0\nTEMP r;\nADD r, r,@;\nEND", "the second operand of ADD is missing",
          "write ADD r, r, second;"},
         {"!!ARBfp1.0\nTEMP r;\nADD r,@, r;\nEND", "the first operand of ADD is missing",
          "write ADD r, first, r;"},
         {"!!ARBfp1.0\nTEMP r;\nRCP r@;\nEND", "the operand of RCP is missing",
          "write RCP r, value.x;"},
         {"!!ARBfp1.0\nADD@;\nEND", "the destination of ADD is missing",
          "write ADD dst, first, second;"},
         {"!!ARBfp1.0\nKIL@;\nEND", "the operand of KIL is missing", "write KIL value;"},
         {"!!ARBfp1.0\nTEMP r;\nSWZ r, r, x, y, z@;\nEND", "the fourth selector of SWZ is missing",
          "write SWZ r, r, x, y, z, w;"},
         {"!!ARBfp1.0\nTEMP r;\nADD r, r@\nMOV r, r;\nEND", "the second operand of ADD is missing",
          "write ADD r, r, second;"},
         {"!!ARBfp1.0\nTEMP r;\nADD r, r,@\nMOV r, r;\nEND", "the second operand of ADD is missing",
          "write ADD r, r, second;"}});
}

TEST(Parts, ThatAreMissingAreNamedInNvidiasLanguages) {
  names({{"!!ARBfp1.0\nOPTION NV_fragment_program;\nTEMP r;\nTEX r, r, texture[0]@;\nEND",
          "the texture target of TEX is missing", "write TEX r, r, texture[0], 2D;"},
         {"!!ARBfp1.0\nOPTION NV_fragment_program;\nTEMP r;\nADD r (EQ), r@;\nEND",
          "the second operand of ADD is missing", "write ADD dst, r, second;"},
         {"!!FP1.0\nTEX R0, f[TEX0], TEX0@;\nEND", "the texture target of TEX is missing",
          "write TEX R0, f[TEX0], TEX0, 2D;"},
         {"!!FP1.0\nADD R0, R1@;\nEND", "the second operand of ADD is missing",
          "write ADD R0, R1, second;"},
         {"!!VP1.0\nMOV@;\nEND", "the destination of MOV is missing", "write MOV dst, value;"}});
}

TEST(Parts, ThatAreMissingAreNamedInAtis) {
  names({{"!!ATIfs1.0\nStartOutputPass;\nMAD r0, r1, r2@;\nEndPass;\n",
          "the third argument of MAD is missing", "MAD takes a register and 3 arguments"},
         {"!!ATIfs1.0\nStartOutputPass;\nMOV r0@;\nEndPass;\n", "the argument of MOV is missing",
          "MOV takes a register and 1 argument"}});
}

TEST(Parts, WithoutTheirCommaAndTooManyAreNamed) {
  names(
      {{"!!ARBfp1.0\nTEMP r;\nADD r, r @r;\nEND",
        "expected ',' before the second operand of ADD, found 'r'", ""},
       {"!!ARBfp1.0\nTEMP r;\nTEX r, r, texture[0] @2D;\nEND",
        "expected ',' before the texture target of TEX, found '2D'", ""},
       {"!!ARBfp1.0\nTEMP r;\nADD r, r, r@, r;\nEND", "expected ';', found ','",
        "write ADD r, r, r;"},
       {"!!FP1.0\nADD R0, R1, R1@, R1;\nEND", "expected ';', found ','", "write ADD R0, R1, R1;"}});
}

TEST(LostSemicolon, IsSaidAtTheEndOfTheStatementThatLacksIt) {
  names({{"!!ARBfp1.0\nTEMP r;\nMOV r, {1, 2}@\nMOV r, r;\nEND", "expected ';' after '}'", ""},
         {"!!ARBfp1.0\nTEMP r;\nMOV r, r.x@ # why\n\nMOV r, r;\nEND", "expected ';' after 'x'", ""},
         {"!!ARBfp1.0\nTEMP r;\nMOV r, r@\nEND", "expected ';' after 'r'", ""},
         {"!!ARBfp1.0\nTEMP r;\nMOV r, r@\nMADD r, r;\nEND", "expected ';' after 'r'", ""},
         {"!!ARBfp1.0\nTEMP r;\nMOV r, r@", "expected ';' after 'r'", ""},
         {"!!ARBfp1.0\nTEMP r@\nMOV r, r;\nEND", "expected ';' after 'r'", ""},
         {"!!ARBfp1.0\nTEMP r@\ns;\nEND", "expected ',' or ';' after 'r'", ""},
         {"!!ARBfp1.0\nPARAM p = 1@\nTEMP r;\nEND", "expected ';' after '1'", ""},
         {"!!ARBfp1.0\nOPTION ARB_fog_exp@\nTEMP r;\nEND", "expected ';' after 'ARB_fog_exp'", ""},
         {"!!ARBfp1.0\nOPTION NV_fragment_program2;\nIF TR@\nENDIF;\nEND",
          "expected ';' after 'TR'", ""},
         {"!!FP1.0\nMOV R0, f[COL0]@\nMOV o[COLR], R0;\nEND", "expected ';' after ']'", ""},
         {"!!VP1.1\nOPTION NV_position_invariant@\nMOV o[COL0], v[0];\nEND",
          "expected ';' after 'NV_position_invariant'", ""},
         {"!!ATIfs1.0\nStartOutputPass;\nMOV r0, color0@\nEndPass;\n",
          "expected ';' after 'color0'", ""},
         {"!!ATIfs1.0\nStartOutputPass@\nMOV r0, color0;\nEndPass;\n",
          "expected ';' after 'StartOutputPass'", ""},
         {"!!RC1.0\nfinal_product = zero * zero;\nclamp_color_sum()@\nout.rgb = zero;\n",
          "expected ';' after ')'", ""}});
}

TEST(Parts, MayBeNamedAsAnInstructionIs) {
  CompileOptions options = generous();
  options.limits.nvOptions = 2;
  for (const char *const between : {" ", "\n"}) {
    const std::string text =
        "!!FP1.0\nDEFINE MOV = 1;\nADD o[COLR], f[COL0]," + std::string(between) + "MOV;\nEND";
    EXPECT_TRUE(check(text, options).ok()) << check(text, options).errorString(text);
  }
}

TEST(Parts, AreAsManyAsTheInstructionHas) {
  EXPECT_EQ(partCount(ir::Opcode::Mov), 2);
  EXPECT_EQ(partCount(ir::Opcode::Kil), 1);
  EXPECT_EQ(partCount(ir::Opcode::Tex), 4);
  EXPECT_EQ(partCount(ir::Opcode::Txd), 6);
  EXPECT_EQ(partCount(ir::Opcode::Swz), 6);
  EXPECT_EQ(partCount(ir::Opcode::Brk), 0);
}

/// "line: message" of every error, one a line.
std::string errorsOf(const std::string &text) {
  std::string all;
  CompileOptions options = generous();
  options.limits.nvOptions = 2;
  for (const Diagnostic &each : check(text, options).diagnostics)
    all += std::to_string(locate(text, each.span.begin).line) + ": " + each.message + "\n";
  return all;
}

TEST(Recovery, ReadsOnAtTheLineBehindALostSemicolon) {
  EXPECT_EQ(errorsOf("!!ARBfp1.0\nTEMP r\nMOVV r, fragment.color;\nADDD r, r\nMUL r, r, q;\nEND"),
            "2: expected ',' or ';' after 'r'\n3: unknown instruction 'MOVV'\n"
            "4: unknown instruction 'ADDD'\n5: 'q' is not declared\n");
  EXPECT_EQ(errorsOf("!!FP1.0\nMOV R0, R1\nMOVV R0, R1;\nMOV o[COLR], R0;\nEND"),
            "2: expected ';' after 'R1'\n3: 'MOVV' is no instruction of !!FP1.0\n");
  EXPECT_EQ(errorsOf("!!ATIfs1.0\nStartOutputPass;\nMOV r0, r1\nMULL r0, r0, r1;\nEndPass;\n"),
            "3: expected ';' after 'r1'\n4: unknown instruction 'MULL'\n");
}

TEST(Recovery, MakesNoErrorOfALineThatGoesOn) {
  EXPECT_EQ(errorsOf("!!ARBfp1.0\nTEMP r;\nMUL r, r\n  r;\nMAD r, r,\n  q r, r;\nEND"),
            "4: expected ',' before the second operand of MUL, found 'r'\n"
            "6: 'q' is not declared\n6: expected ',' before the third operand of MAD, found 'r'\n");
  EXPECT_EQ(errorsOf("!!ARBfp1.0\nTEMPP a,\n  b;\nMOV a, b;\nEND"),
            "2: unknown instruction 'TEMPP'\n")
      << "the names are accepted";
}

} // namespace
} // namespace arbiter::fp
