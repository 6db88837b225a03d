// What is said of an instruction that the language does not have: what it means here, if it is a
// word of another language, else the opcode that is nearest in letters and in operands.
#include "fp_compiler/front/words/other_words.h"

#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"

namespace arbiter::fp {
namespace {

using testing_support::check;
using testing_support::generous;

/// The hint of the first error.
std::string hintOf(const std::string &text) {
  CompileOptions options = generous();
  options.limits.nvOptions = 2;
  options.limits.nvVertexProgram = 1;
  const CheckResult result = check(text, options);
  return result.diagnostics.empty() ? "none" : result.diagnostics.front().hint;
}

std::string fragment(const std::string &statement) {
  return hintOf("!!ARBfp1.0\nTEMP r, s;\n" + statement + "\nEND\n");
}
std::string vertex(const std::string &statement) {
  return hintOf("!!ARBvp1.0\nTEMP r, s;\n" + statement + "\nEND\n");
}
std::string option(const std::string &name, const std::string &statement) {
  return hintOf("!!ARBfp1.0\nOPTION " + name + ";\nTEMP r, s;\n" + statement + "\nEND\n");
}
std::string ati(const std::string &statement) {
  return hintOf("!!ATIfs1.0\nStartOutputPass;\n" + statement + "\nEndPass;\n");
}
std::string meant(const std::string &word) { return "did you mean '" + word + "'?"; }

TEST(OtherWords, AreTheInstructionsThatMeanTheSame) {
  EXPECT_EQ(fragment("MADD r, r, s, s;"), meant("MAD"));
  EXPECT_EQ(fragment("DOT3 r, r, s;"), meant("DP3"));
  EXPECT_EQ(fragment("DOT4 r, r, s;"), meant("DP4"));
  EXPECT_EQ(fragment("dot3 r, r, s;"), meant("DP3"));
  EXPECT_EQ(fragment("TEX2D r, s, texture[0], 2D;"), meant("TEX"));
  EXPECT_EQ(fragment("texldp r, t0, s0;"), meant("TXP"));
  EXPECT_EQ(fragment("LERP r, r, s, s;"), meant("LRP"));
  EXPECT_EQ(fragment("DISCARD r;"), meant("KIL"));
  EXPECT_EQ(fragment("FRACT r, s;"), meant("FRC"));
  EXPECT_EQ(fragment("INVERSESQRT r, s.x;"), meant("RSQ"));
  EXPECT_EQ(fragment("VAR r;"), meant("TEMP"));
  EXPECT_EQ(fragment("DEFINE r = 1;"), meant("PARAM"));
  EXPECT_EQ(vertex("mova r.x, s.x;"), meant("ARL"));
}

TEST(OtherWords, KeepTheSaturation) {
  EXPECT_EQ(fragment("MADD_SAT r, r, s, s;"), meant("MAD_SAT"));
  EXPECT_EQ(fragment("mul_sat r, r, s;"), meant("MUL_SAT"));
  EXPECT_EQ(fragment("ADDD_SAT r, r, s;"), meant("ADD_SAT"));
  EXPECT_EQ(fragment("mad_pp r, r, s, s;"), meant("MAD"));
  EXPECT_NE(fragment("SATURATE r, s;").find("_SAT behind the opcode"), std::string::npos);
  EXPECT_EQ(vertex("SATURATE r, s;"), "MAX with 0 and MIN with 1 together do it");
  EXPECT_NE(ati("SATURATE r0, r1;").find(".sat"), std::string::npos);
}

TEST(OtherWords, AreMadeOfOthersWhereTheLanguageHasNone) {
  const std::string normalize =
      "DP3, RSQ and MUL together do it: DP3 tmp.w, s, s; RSQ tmp.w, tmp.w; MUL r, s, tmp.w;";
  EXPECT_EQ(fragment("NORMALIZE r, s;"), normalize);
  EXPECT_EQ(option("NV_fragment_program2", "NORMALIZE r, s;"), meant("NRM"));
  EXPECT_EQ(option("NV_fragment_program", "NORMALIZE r, s;"), normalize);
  EXPECT_EQ(vertex("LERP r, r, s, {1};"),
            "SUB and MAD together do it: SUB tmp, s, {1}; MAD r, r, tmp, {1};");
  EXPECT_EQ(fragment("SQRT r, s;"), "RSQ and RCP together do it: RSQ tmp.x, s.x; RCP r, tmp.x;");
  EXPECT_EQ(fragment("DIVIDE r, s, 2.0;"),
            "RCP and MUL together do it: RCP tmp.x, {2.0}.x; MUL r, s, tmp.x;");
  EXPECT_EQ(fragment("DISTANCE r.x, s * 2;").substr(0, 62),
            "SUB, DP3, RSQ and RCP together do it: SUB tmp, first, second; ");
  EXPECT_EQ(fragment("CEIL r, s;"), "FLR of the negated operand, negated, is the same");
  EXPECT_EQ(hintOf("!!VP1.0\nSUB R0, R0, R1;\nEND\n"),
            "write ADD with a minus before the second operand");
}

TEST(OtherWords, OfEachLanguageAreItsOwn) {
  EXPECT_EQ(ati("DP3 r0, r1, r2;"), meant("DOT3"));
  EXPECT_EQ(ati("LRP r0, r1, r2, r3;"), meant("LERP"));
  EXPECT_EQ(ati("TEX r0, t0;"), meant("SampleMap"));
  EXPECT_EQ(hintOf("!!FP1.0\nMADD R0, R0, R1, R1;\nEND\n"), meant("MAD"));
  EXPECT_EQ(option("NV_fragment_program", "MADD r, r, s, s;"), meant("MAD"));
  EXPECT_EQ(option("NV_fragment_program", "MOVQ r, r;"), "MOV has no such suffix here");
}

TEST(OtherWords, OfSeveralMeaningsAreAllNamed) {
  EXPECT_EQ(fragment("DOT r, r, s;"), "the words for it are DP3 and DP4");
}

TEST(Spelling, OfEquallyNearOpcodesTheOperandsDecide) {
  EXPECT_EQ(fragment("MAV r, s;"), meant("MOV"));
  EXPECT_EQ(fragment("MAV r, r, s;"), meant("MAX"));
  EXPECT_EQ(fragment("MAV r, r, s, {1, 2};"), meant("MAD"));
  EXPECT_EQ(fragment("MAV r, r, s, s, s;"), meant("MAD")) << "no opcode has so many: the first";
  EXPECT_EQ(fragment("SUBB r, r, s;"), meant("SUB"));
  EXPECT_EQ(fragment("QQQ r, r;"), "");
}

TEST(Parts, AreCountedToTheStatementsEnd) {
  EXPECT_EQ(partsBehind(" a, b, {1, 2, 3}; c, d", 0).size(), 3u);
  EXPECT_EQ(partsBehind(" a", 0).size(), 1u);
  EXPECT_EQ(partsBehind(";", 0).size(), 0u);
  EXPECT_EQ(partsBehind("", 0).size(), 0u);
  EXPECT_EQ(partsBehind(testing_support::repeat("a,", 1000), 0).size(), 0u);
}

TEST(OtherWords, AreInCapitalsAndOnceInARow) {
  constexpr std::string_view kRows[] = {
#define OTHER_WORDS(words, opcodes, advice) words, opcodes,
#define OTHER_FUNCTION(name, opcodes, advice)
#include "fp_compiler/front/words/other_words.def"
  };
  for (const std::string_view row : kRows) {
    std::set<std::string> seen;
    std::istringstream words{std::string(row)};
    for (std::string word; words >> word;) {
      EXPECT_TRUE(seen.insert(word).second) << word;
      EXPECT_EQ(word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"), std::string::npos)
          << word;
    }
  }
}

} // namespace
} // namespace arbiter::fp
