#include "fp_compiler/diagnostic.h"

#include <gtest/gtest.h>
#include <set>

#include "fp_compiler/front/diagnostic_ids.h"
#include "fp_compiler/front/reporter.h"
#include "fp_compiler/limits.h"

namespace arbiter::fp {
namespace {

LineColumn at(std::string_view text, std::uint32_t offset) { return locate(text, offset); }
void expectAt(std::string_view text, std::uint32_t offset, std::uint32_t line,
              std::uint32_t column) {
  EXPECT_EQ(at(text, offset).line, line) << offset;
  EXPECT_EQ(at(text, offset).column, column) << offset;
}

TEST(Locate, EachLineEndCountsOnce) {
  expectAt("ab\ncd", 0, 1, 1);
  expectAt("ab\ncd", 2, 1, 3);
  expectAt("ab\ncd", 3, 2, 1);
  expectAt("ab\r\ncd", 3, 1, 4);
  expectAt("ab\r\ncd", 4, 2, 1);
  expectAt("ab\rcd", 3, 2, 1);
  expectAt("\n\r\n\r\n", 5, 4, 1);
  expectAt("ab", 99, 1, 3);
}

Diagnostic sample(Span span) {
  return {Severity::Error, "undeclared_name", span, "'x' is not declared", "declare it"};
}

TEST(Render, LineCaretAndHint) {
  const std::string text = "!!ARBfp1.0\r\nMOV\tfoo, 1;\r\nEND";
  EXPECT_EQ(render("a.fp", text, sample({16, 19})),
            "a.fp:2:5: error: 'x' is not declared [undeclared_name]\n"
            "  MOV foo, 1;\n"
            "      ^~~\n"
            "  hint: declare it\n");
  EXPECT_EQ(renderLine("a.fp", text, sample({16, 19})),
            "a.fp:2:5: error: 'x' is not declared [undeclared_name]");
}

TEST(Render, AllIsEachInTurn) {
  const std::string text = "a\r\nb\nc\rd\n\ne";
  std::vector<Diagnostic> all;
  std::string expected;
  for (std::uint32_t at : {0u, 0u, 2u, 3u, 5u, 7u, 11u, 4u, 99u}) {
    all.push_back(sample({at, at + 1}));
    expected += render("p", text, all.back());
  }
  EXPECT_EQ(renderAll("p", text, all), expected);
}

TEST(Render, TheEndOfTheText) {
  EXPECT_EQ(render("p", "END", sample({3, 3})),
            "p:1:4: error: 'x' is not declared [undeclared_name]\n  END\n     ^\n"
            "  hint: declare it\n");
}

TEST(Render, LongLinesAreCutAndBytesMadeVisible) {
  const std::string text = std::string(1000, 'a') + "\x01\xC3" + std::string(1000, 'b');
  const std::string out = render("p", text, sample({1000, 1900}));
  EXPECT_LT(out.size(), 400u);
  EXPECT_NE(out.find("..." + std::string(60, 'a') + "??" + std::string(58, 'b') + "...\n"),
            std::string::npos)
      << out;
  EXPECT_NE(out.find(std::string(65, ' ') + "^" + std::string(59, '~') + "\n"), std::string::npos)
      << out;
}

TEST(DiagnosticIds, AreDistinctKebabCaseAndExplained) {
  std::set<std::string> seen;
  for (const DiagnosticInfo &row : diagnosticTable()) {
    EXPECT_TRUE(seen.insert(row.id).second) << row.id;
    EXPECT_EQ(std::string(row.id).find_first_not_of("abcdefghijklmnopqrstuvwxyz_"),
              std::string::npos);
    EXPECT_GT(std::string(row.meaning).size(), 10u) << row.id;
  }
}

TEST(Reporter, SortsAndKeepsErrorsBeforeWarnings) {
  Reporter reporter;
  for (std::uint32_t i = 0; i < kMaxDiagnostics; ++i)
    reporter.warning(DiagnosticId::NumeralOverflow, {i, i}, "w");
  reporter.error(DiagnosticId::Syntax, {500, 500}, "late");
  reporter.error(DiagnosticId::Syntax, {1, 1}, "early");
  const std::vector<Diagnostic> all = reporter.take();
  ASSERT_EQ(all.size(), kMaxDiagnostics);
  EXPECT_EQ(all[2].message, "early");
  EXPECT_EQ(all.back().message, "late");
}

TEST(Reporter, StopsAtTheLimit) {
  Reporter reporter;
  for (std::uint32_t i = 0; i < 2 * kMaxDiagnostics; ++i)
    reporter.error(DiagnosticId::Syntax, {i, i}, "e");
  EXPECT_TRUE(reporter.full());
  EXPECT_EQ(reporter.take().size(), kMaxDiagnostics);
}

TEST(Quote, IsPrintableAndShort) {
  EXPECT_EQ(quote("a\nb\xFF"), "'a?b?'");
  EXPECT_LT(quote(std::string(1000, 'x')).size(), 60u);
}

} // namespace
} // namespace arbiter::fp
