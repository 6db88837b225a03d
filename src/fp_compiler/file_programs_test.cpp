#include "fp_compiler/file_programs.h"

#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"

namespace arbiter::fp {
namespace {

using ir::Language;

constexpr std::string_view kVertex =
    "!!ARBvp1.0\nOPTION ARB_position_invariant; # END of options\nMOV result.color, "
    "vertex.color;\nEND";
constexpr std::string_view kFragment =
    "!!ARBfp1.0\nTEMP ENDED;\nMOV ENDED, fragment.color;\nMOV result.color, ENDED;\nEND";

std::string pair() {
  return "# A material's programs.\n\n" + std::string(kVertex) + "\n\n# The other.\n" +
         std::string(kFragment) + "\n# done\n";
}

CheckResult checkIn(std::string_view file, std::size_t number) {
  const FileProgram program = programsOf(file).at(number);
  return checkProgramIn(file, program, testing_support::small());
}

TEST(FilePrograms, APairBehindComments) {
  const std::string file = pair();
  const auto programs = programsOf(file);
  ASSERT_EQ(programs.size(), 2u);
  EXPECT_EQ(programs[0].language, Language::ArbVertex);
  EXPECT_EQ(programs[0].in(file), kVertex);
  EXPECT_EQ(programs[1].language, Language::ArbFragment);
  EXPECT_EQ(programs[1].in(file), kFragment);
  EXPECT_EQ(programOf(file, Language::ArbFragment).in(file), kFragment);
  EXPECT_EQ(programOf(file, Language::AtiFragment).in(file), file);
}

TEST(FilePrograms, WhatIsOneTextStaysOneText) {
  for (const std::string_view file :
       {"", "no program at all", "!!ARBfp1.0\nEND\nbehind", "\xEF\xBB\xBF!!ARBfp1.0\nEND",
        "words before\n!!ARBfp1.0\nEND\n", "puts(\"!!ARBfp1.0\\nEND\");\n"}) {
    const auto programs = programsOf(file);
    ASSERT_EQ(programs.size(), 1u) << file;
    EXPECT_EQ(programs[0].in(file), file);
  }
}

TEST(FilePrograms, CommentsOfEveryKindMayComeFirst) {
  for (const std::string_view before :
       {"\n\n", "# of !!ARBvp1.0\r\n", "// one\n/* two\n!!ARBvp1.0 */ ", "\t"}) {
    const std::string file = std::string(before) + "!!ARBfp1.0 END\nwords\n";
    const auto programs = programsOf(file);
    ASSERT_EQ(programs.size(), 1u) << before;
    EXPECT_EQ(programs[0].in(file), "!!ARBfp1.0 END");
  }
  EXPECT_EQ(programsOf("/* without an end !!ARBfp1.0")[0].span.begin, 0u);
}

TEST(FilePrograms, AProgramWithoutItsEndReachesToTheNextHeader) {
  const std::string file = "!!ARBvp1.0\nMOV result.color, vertex.color;\n!!ARBfp1.0\nEND\n";
  const auto programs = programsOf(file);
  ASSERT_EQ(programs.size(), 2u);
  const CheckResult result = checkIn(file, 0);
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_STREQ(result.diagnostics[0].id, "end_missing");
  EXPECT_EQ(locate(file, result.diagnostics[0].span.begin).line, 3u);
}

TEST(FilePrograms, TextsThatHaveNoEnd) {
  const std::string file = "!!ATIfs1.0\nStartOutputPass;\nMOV r0, color0;\nEndPass;\n"
                           "!!RC1.0\nout.rgb = col0;\n!!VP1.0\nMOV o[HPOS], v[OPOS];\nEND\n";
  const auto programs = programsOf(file);
  ASSERT_EQ(programs.size(), 3u);
  EXPECT_EQ(programs[0].language, Language::AtiFragment);
  EXPECT_EQ(programs[1].language, Language::Combiners);
  EXPECT_EQ(programs[2].language, Language::ArbVertex);
}

TEST(FilePrograms, TextureShadersAndTheirCombinersAreOneText) {
  const std::string file = "# both\n!!TS1.0\ntexture_2d();\n!!RC1.0\nout.rgb = col0;\n!!RC1.0\n";
  const auto programs = programsOf(file);
  ASSERT_EQ(programs.size(), 1u);
  EXPECT_EQ(programs[0].in(file), file.substr(7));
}

TEST(FilePrograms, PlacesAreThoseOfTheFile) {
  std::string file = pair();
  const std::size_t wrong = file.rfind("ENDED;");
  file.replace(wrong, 5, "ENDER");
  const CheckResult result = checkIn(file, 1);
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_EQ(result.errorPosition(), std::int32_t(wrong));
  EXPECT_TRUE(checkIn(file, 0).ok());

  const std::string whole = pair();
  const CheckResult good = checkIn(whole, 1);
  ASSERT_TRUE(good.ok());
  const ir::Instruction &last = good.program->code.back();
  const auto text = [&](Span span) {
    return std::string_view(whole).substr(span.begin, span.end - span.begin);
  };
  EXPECT_EQ(text(last.span), "MOV result.color, ENDED");
  EXPECT_EQ(text(last.dst.span), "result.color");
  EXPECT_EQ(text(last.src[0].span), "ENDED");

  const Inspection inspection =
      inspectProgramIn(whole, programsOf(whole)[1], testing_support::small());
  const Name *const name = inspection.names.find("ENDED");
  ASSERT_NE(name, nullptr);
  EXPECT_EQ(name->declared.begin, whole.find("TEMP ENDED") + 5);
  EXPECT_NE(inspection.names.at(std::uint32_t(whole.rfind("ENDED"))), nullptr);
}

TEST(FilePrograms, AHeaderOfAnotherVersionIsWrongWhereItStands) {
  const std::string file = "# 1\n# 2\n!!ARBvp1.0\nEND\n!!ARBfp1.7\nEND\n";
  const CheckResult result = checkIn(file, 1);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.errorPosition(), std::int32_t(file.find(".7") + 1));
}

TEST(FilePrograms, GlRefusesAHeaderBehindSomething) {
  const CheckResult behind = checkIn("# why\n!!ARBfp1.0\nMOV result.color, 1;\nEND\n", 0);
  EXPECT_TRUE(behind.ok());
  ASSERT_EQ(behind.diagnostics.size(), 1u);
  EXPECT_STREQ(behind.diagnostics[0].id, "header_behind");
  EXPECT_EQ(behind.diagnostics[0].severity, Severity::Warning);
  EXPECT_EQ(behind.diagnostics[0].span, (Span{6, 16}));
  EXPECT_TRUE(checkIn(pair(), 0).diagnostics.empty()) << "a pair needs such a loader";
}

} // namespace
} // namespace arbiter::fp
