// Tests the warnings of valid programs that hardly mean what they say, and their absence.
#include "fp_compiler/doubts/doubts.h"

#include <string>

#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"

namespace arbiter::fp {
namespace {

using testing_support::generous;

/// The warnings, as "line: id: message; hint", one a line.
std::string doubts(const std::string &text) {
  CompileOptions options = generous();
  options.limits.nvOptions = 2;
  options.limits.nvVertexProgram = 1;
  const FileProgram program = programsOf(text).front();
  CheckResult result = checkProgramIn(text, program, options);
  EXPECT_TRUE(result.ok()) << text << result.errorString(text);
  const std::string before = result.errorString(text);
  EXPECT_EQ(before, "") << text;
  addDoubts(text, program, result);
  EXPECT_TRUE(result.ok());
  EXPECT_EQ(result.errorPosition(), -1);
  std::string said;
  for (const Diagnostic &each : result.diagnostics) {
    EXPECT_EQ(each.severity, Severity::Warning);
    said += std::to_string(locate(text, each.span.begin).line) + ": " + each.id + ": " +
            each.message + "\n";
  }
  return said;
}

std::string fragment(const std::string &statements) {
  return doubts("!!ARBfp1.0\nTEMP r, s;\n" + statements + "\nEND\n");
}
std::string vertex(const std::string &statements) {
  return doubts("!!ARBvp1.0\nOPTION ARB_position_invariant; TEMP r, s; ADDRESS A;\n" + statements +
                "\nEND\n");
}
std::string option(const std::string &name, const std::string &statements) {
  return doubts("!!ARBfp1.0\nOPTION " + name + "; TEMP r, s;\n" + statements + "\nEND\n");
}

TEST(Unwritten, TemporariesAreNamedOnceWhereTheyAreReadFirst) {
  EXPECT_EQ(fragment("ADD result.color, r, s;\nMUL result.depth.z, r.x, s.x;"),
            "3: unwritten_temporary: 'r' is read before anything writes it\n"
            "3: unwritten_temporary: 's' is read before anything writes it\n");
  EXPECT_EQ(fragment("MUL result.color, r, 2.0;\nMOV r, 1.0;\nMOV result.depth.z, r.x;"),
            "3: unwritten_temporary: 'r' is read before anything writes it\n");
  EXPECT_EQ(fragment("ADD r, r, 1.0;\nMOV result.color, r;"),
            "3: unwritten_temporary: 'r' is read before anything writes it\n");
  EXPECT_EQ(fragment("MOV result.color, 1.0;\nKIL r.x;"),
            "4: unwritten_temporary: 'r' is read before anything writes it\n");
}

TEST(Unwritten, ComponentsCountAlone) {
  EXPECT_EQ(fragment("MOV r.xyz, 1.0;\nMUL result.color, r, 2.0;"),
            "4: unwritten_temporary: 'r.w' is read before anything writes it\n");
  EXPECT_EQ(fragment("MOV r.xy, 1.0;\nTEX result.color, r, texture[0], 2D;"), "");
  EXPECT_EQ(fragment("MOV r.xyz, 1.0;\nMUL s, r, 2.0;\nDP3 result.color, s, s;"), "")
      << "s.w reaches no result";
  EXPECT_EQ(fragment("MOV r.x, 1.0;\nRSQ r.y, r.x;\nMOV result.color, r.xyxy;"), "");
  EXPECT_EQ(fragment("SWZ result.color, r, 0, 1, 1, 1;"), "");
  EXPECT_EQ(fragment("MOV r.x, 1.0;\nLIT result.color.xy, r;"), "");
  EXPECT_EQ(vertex("MOV r.xy, vertex.texcoord[0];\nMOV result.texcoord[0], r;"), "")
      << "a sample may read two components";
}

TEST(Unwritten, ResultsAreToldAtTheHeader) {
  EXPECT_EQ(fragment("MOV r, 1.0;\nMOV s, r;"),
            "1: unwritten_result: nothing writes result.color, so the fragment's colour is "
            "undefined\n")
      << "that the writes are unused follows from it";
  EXPECT_EQ(fragment("MOV result.depth.z, 1.0;"), "");
  EXPECT_EQ(fragment("KIL fragment.color;"), "") << "it may draw to a depth buffer alone";
  EXPECT_EQ(doubts("!!ARBvp1.0\nMOV result.color, vertex.color;\nEND\n"),
            "1: unwritten_result: nothing writes result.position\n");
  EXPECT_EQ(doubts("!!ARBvp1.0\nMOV result.position.xyz, vertex.position;\nEND\n"),
            "1: unwritten_result: nothing writes result.position.w\n");
  EXPECT_EQ(vertex("MOV result.color, vertex.color;"), "");
  EXPECT_EQ(doubts("!!ARBvp1.0\nMOV result.position.xyz, vertex.position;\n"
                   "MOV result.position.w, 1.0;\nEND\n"),
            "");
}

TEST(Unused, WritesAreToldWhereTheyStand) {
  EXPECT_EQ(fragment("MOV r, fragment.color;\nMOV result.color, 1.0;"),
            "3: unused_write: 'r' is written, but nothing reads it\n");
  EXPECT_EQ(fragment("MOV r, 0.0;\nMOV r, 1.0;\nMOV result.color, r;"),
            "3: unused_write: 'r' is overwritten in line 4 before anything reads it\n");
  EXPECT_EQ(fragment("MOV result.color, 0.0;\nMOV result.color, 1.0;"),
            "3: unused_write: 'result.color' is overwritten in line 4 before anything reads it\n");
  EXPECT_EQ(fragment("MOV result.color, 0.0;\nMOV result.depth.x, 0.5;"),
            "4: unused_write: 'result.depth.x' is no component that counts\n");
  EXPECT_EQ(vertex("ARL A.x, vertex.color.x;\nMOV result.color, 1.0;"),
            "3: unused_write: 'A.x' is written, but nothing reads it\n");
  EXPECT_EQ(fragment("MOV r, 0.0;\nADD s, r, 1.0;\nMOV result.color, 1.0;"),
            "4: unused_write: 's' is written, but nothing reads it\n")
      << "one mistake, one warning";
}

TEST(Unused, PartsThatAreReadKeepAnInstruction) {
  EXPECT_EQ(fragment("MOV r, 0.0;\nMOV r.x, 1.0;\nMOV result.color, r;"), "");
  EXPECT_EQ(fragment("MUL r, fragment.color, 2.0;\nMOV result.color, r.x;"), "");
  EXPECT_EQ(fragment("MOV result.color, 0.0;\nMOV result.color.w, 1.0;"), "");
  EXPECT_EQ(fragment("MOV result.depth, 0.5;\nMOV result.color, 0.5;"), "");
  EXPECT_EQ(fragment("MOV r, fragment.color;\nADD r, r, r;\nMOV result.color, r;"), "");
  EXPECT_EQ(fragment("MOV r, fragment.color;\nKIL r;\nMOV result.color, 1.0;"), "");
  EXPECT_EQ(vertex("PARAM c[2] = {{1}, {2}};\nARL A.x, vertex.color.x;\n"
                   "MOV result.color, c[A.x];"),
            "");
}

TEST(Doubts, ConditionsAndBranchesLeaveNone) {
  EXPECT_EQ(option("NV_fragment_program", "MOVC r, fragment.color;\nMOV s (GT.x), r;\n"
                                          "MOV s (LE.x), 1.0;\nMOV result.color, s;"),
            "");
  EXPECT_EQ(option("NV_fragment_program", "ADDC r, fragment.color, 1.0;\n"
                                          "MOV result.color, 1.0;\nKIL GT.x;"),
            "");
  EXPECT_EQ(option("NV_fragment_program2", "MOVC r.x, fragment.color;\nIF GT.x;\nMOV s, r.x;\n"
                                           "ELSE;\nMOV s, 1.0;\nENDIF;\nMOV result.color, s;"),
            "");
  EXPECT_EQ(option("NV_fragment_program2", "MOV r, 0.0;\nREP {4};\nADD r, r, s;\nMOV s, 1.0;\n"
                                           "ENDREP;\nMOV result.color, r;"),
            "");
  EXPECT_EQ(option("NV_fragment_program2", "CAL load;\nMOV result.color, r;\nRET;\nload:\n"
                                           "MOV r, fragment.color;\nRET;"),
            "");
  EXPECT_EQ(doubts("!!ARBvp1.0\nOPTION NV_vertex_program2; OPTION ARB_position_invariant;\n"
                   "TEMP r; ADDRESS A;\nMOV r, 4.0;\nagain:\nADDC r, r, -1.0;\n"
                   "BRA again (GT.x);\nMOV result.color, r;\nEND\n"),
            "");
}

TEST(Doubts, AreThereUnderNvidiasOptionsToo) {
  EXPECT_EQ(option("NV_fragment_program", "MOV r, fragment.color;\nMUL result.color, s, 2.0;"),
            "3: unused_write: 'r' is written, but nothing reads it\n"
            "4: unwritten_temporary: 's' is read before anything writes it\n");
  EXPECT_EQ(option("NV_fragment_program2", "MOVC r.x, fragment.color;\nIF GT.x;\n"
                                           "MOV result.color, s;\nENDIF;"),
            "5: unwritten_temporary: 's' is read before anything writes it\n");
}

TEST(Doubts, NvidiasOwnLanguagesBeginWithZeros) {
  EXPECT_EQ(doubts("!!FP1.0\nADD R0, R0, f[COL0];\nMOV o[COLR], R0;\nEND\n"), "");
  EXPECT_EQ(doubts("!!VP1.0\nMAD R0, R0, v[OPOS], v[OPOS];\nMOV o[HPOS], R0;\nEND\n"), "");
}

TEST(Doubts, OfAProgramBehindOthersHaveTheirPlaceInTheFile) {
  const std::string file = "# both\n!!ARBvp1.0\nOPTION ARB_position_invariant;\nEND\n"
                           "!!ARBfp1.0\nTEMP r;\nMOV result.color, r;\nEND\n";
  const FileProgram program = programsOf(file).at(1);
  CheckResult result = checkProgramIn(file, program, generous());
  addDoubts(file, program, result);
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_EQ(locate(file, result.diagnostics[0].span.begin).line, 7u);
}

TEST(Doubts, AreNotForGl) {
  EXPECT_EQ(testing_support::check("!!ARBfp1.0\nTEMP r;\nMOV r, 1.0;\nEND\n").diagnostics.size(),
            0u);
}

} // namespace
} // namespace arbiter::fp
