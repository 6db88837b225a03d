// Tests each part of a report with a NativeReport made by hand, in place of a model's.
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>

#include "apps/tools/language.h"
#include "apps/tools/page/html.h"
#include "apps/tools/report/gauges.h"
#include "apps/tools/report/histogram.h"
#include "apps/tools/report/json.h"
#include "apps/tools/report/line_costs.h"
#include "apps/tools/report/page.h"
#include "apps/tools/report/section.h"
#include "apps/tools/report/source_table.h"

namespace arbiter::tools {
namespace {

using fp::ResourceCounts;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// Line 5 has two statements; a statement of line 4 ends on line 5.
constexpr const char *kText = "!!ARBfp1.0\r\n"
                              "TEMP a, b;\r\n"
                              "TEX a, fragment.texcoord[0], texture[0], 2D;\r\n"
                              "MUL b, a,\r\n"
                              "  a; MOV a.x, b.y;\r\n"
                              "TEX a, b, texture[1], 2D;\r\n"
                              "MOV result.color, a;\r\n"
                              "END\r\n";

const fp::hw::Profile &profile() { return *fp::hw::findBuiltin("r300"); }

ReportedProgram programOf(const std::string &name, const std::string &text) {
  ReportedProgram program;
  program.file.name = name;
  program.file.text = text;
  program.file.language = chooseLanguage("auto", text);
  program.file.limits = limitsOf(profile(), program.file.language);
  program.file.result = fp::checkProgram(program.file.language, text,
                                         {program.file.limits, fp::LimitPolicy::Enforce});
  if (!program.file.result.ok())
    program.file.status = FileStatus::Invalid;
  admitRefused(program);
  program.verdict = verdictOf(program);
  return program;
}

/// Returns a set of one program that has every part of a report.
ProgramSet modelled() {
  ProgramSet set;
  set.source = "folder";
  set.profile = profile();
  ReportedProgram &program = set.programs.emplace_back(programOf("water.fp", kText));
  fp::hw::NativeReport &native = program.file.native() = {};
  native.model = fp::NativeModel::R300;
  native.counts = program.file.result.counts;
  native.counts.aluInstructions = 70;
  native.counts.texIndirections = 2;
  program.file.result.nativeCounts = native.counts;
  program.file.result.underNativeLimits = false;
  program.file.status = FileStatus::OverNative;
  program.verdict = verdictOf(program);
  native.reasons = {
      {&ResourceCounts::aluInstructions, 68, "MUL <costs> much", {1, 2, 4}},
      {&ResourceCounts::aluInstructions, 2, "the program as a whole", {}},
      {&ResourceCounts::texIndirections, 1, "TEX reads b", {3}},
  };
  native.costs = {
      {0, 1, 0, false}, {1.5, 0, 0, false}, {0, 0, 0, true}, {0, 1, 1, false}, {0.5, 0, 1, false}};
  native.nodes = {{{0}, 2, ""}, {{3}, 1, "TEX reads b, which MUL wrote in node 1"}};
  native.chain = {0, 1, 3};
  native.cycles = {24.5, {{"ALU", 24.5}, {"texture", 4}}, "ALU", "latency"};
  native.disassembly = "node 0: <r0>\n";
  return set;
}

TEST(Html, AnyByteIsShown) {
  EXPECT_EQ(escaped("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;");
  EXPECT_EQ(escaped("\xC3\xA9 \xE9 \x01 \x7F\tx"),
            "\xC3\xA9 <i>\\xE9</i> <i>\\x01</i> <i>\\x7F</i>\tx");
  EXPECT_EQ(escaped("\xED\xA0\x80"), "<i>\\xED</i><i>\\xA0</i><i>\\x80</i>"); // a surrogate
  EXPECT_EQ(escapedAttribute("\xE9\""), "\\xE9&quot;");
}

TEST(Html, LinesAreTheCompilers) {
  EXPECT_THAT(linesOf("a\r\nb\rc\n\nd"), ElementsAre("a", "b", "c", "", "d"));
  EXPECT_THAT(linesOf("a\n"), ElementsAre("a"));
  EXPECT_TRUE(linesOf("").empty());
  EXPECT_EQ(caretIndent("\tab", 3), "\t ");
  EXPECT_EQ(caretIndent("\xC3\xA9x", 3), " "); // two bytes, one character
  EXPECT_EQ(caretIndent("ab", 9), "  ");
}

TEST(HistogramOf, EveryProgramIsInABinAndTheLimitBetweenTwo) {
  std::vector<std::uint32_t> amounts(500);
  for (const std::uint32_t limit : {64u, 96u, 100u, 512u, 1u}) {
    for (std::size_t i = 0; i < amounts.size(); ++i)
      amounts[i] = std::uint32_t(i * 7919 % 257);
    const Histogram histogram = histogramOf(amounts, limit);
    ASSERT_LE(histogram.bins.size(), 26u);
    std::size_t programs = 0;
    bool between = false;
    for (std::size_t i = 0; i < histogram.bins.size(); ++i) {
      const Histogram::Bin &bin = histogram.bins[i];
      EXPECT_EQ(bin.first, i == 0 ? 0 : histogram.bins[i - 1].last + 1);
      const bool open = histogram.open && i + 1 == histogram.bins.size();
      EXPECT_EQ(bin.programs, std::count_if(amounts.begin(), amounts.end(), [&](auto amount) {
                  return amount >= bin.first && (open || amount <= bin.last);
                }));
      programs += bin.programs;
      between |= bin.last == limit;
    }
    EXPECT_EQ(programs, amounts.size());
    EXPECT_TRUE(between) << limit;
  }
}

TEST(HistogramOf, AFarLimitIsSaidAndNotDrawn) {
  const Histogram histogram = histogramOf({3, 5, 9}, 1024);
  EXPECT_EQ(histogram.bins.back().last, 9u);
  const std::string svg = drawing(histogram, "ALU & slots");
  EXPECT_THAT(svg, HasSubstr("limit 1024, beyond the axis"));
  EXPECT_THAT(svg, Not(HasSubstr("class=limit")));
  EXPECT_THAT(svg, HasSubstr("ALU &amp; slots"));
  EXPECT_THAT(drawing(histogramOf({3, 64, 65}, 64), "x"), HasSubstr("class=limit"));
  EXPECT_EQ(drawing(histogramOf({}, 64), "x"), "");
}

TEST(HistogramOf, WithoutRoomEveryProgramIsOver) {
  const std::string svg = drawing(histogramOf({5}, 0), "x");
  EXPECT_THAT(svg, HasSubstr("class=beyond"));
  EXPECT_THAT(svg, HasSubstr("limit 0"));
}

TEST(Gauge, LengthAndMark) {
  EXPECT_THAT(gaugeBar(16, 64), HasSubstr("width:25%"));
  EXPECT_THAT(gaugeBar(16, 64), Not(HasSubstr("<b")));
  EXPECT_THAT(gaugeBar(128, 64), HasSubstr("width:100%\"></span><b style=\"left:50%\">"));
  EXPECT_THAT(gaugeBar(0, 0), HasSubstr("width:0%"));
  EXPECT_THAT(gaugeTable(modelled().programs[0].file), HasSubstr("70 / 64<br>over by 6"));
}

TEST(LineCosts, FollowTheStatements) {
  const ProgramSet set = modelled();
  const CheckedFile &file = set.programs[0].file;
  const SourceText source(file.text);
  const std::vector<LineCost> lines = lineCosts(source, *file.result.program, file.native());
  ASSERT_EQ(lines.size(), 9u); // the last one is empty and follows the last line end
  EXPECT_EQ(lines[2].textures, 1u);
  EXPECT_EQ(lines[3].slots, 1.5);
  EXPECT_EQ(lines[4].gone, 1u);
  EXPECT_EQ(lines[5].firstNode, 1u);
  EXPECT_EQ(std::accumulate(lines.begin(), lines.end(), 0.0,
                            [](double sum, const LineCost &line) { return sum + line.slots; }),
            2.0);
  EXPECT_THAT(linesOfInstructions(source, *file.result.program, {4, 1, 2, 99}),
              ElementsAre(4, 5, 7));
  EXPECT_TRUE(lineCosts(source, *file.result.program, {}).empty());
}

TEST(LineCosts, AreSummedInALine) {
  const CheckedFile file =
      programOf("x", "!!ARBfp1.0\nTEMP a; MOV a, fragment.color; MOV result.color, a; END").file;
  fp::hw::NativeReport report;
  report.costs = {{1, 0, 2, false}, {0.5, 0, 1, false}};
  const auto lines = lineCosts(SourceText(file.text), *file.result.program, report);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1].slots, 1.5);
  EXPECT_EQ(lines[1].instructions, 2u);
  EXPECT_EQ(lines[1].firstNode, 1u);
  EXPECT_EQ(lines[1].lastNode, 2u);
}

TEST(Section, ShowsEveryPart) {
  const std::string html = programSection(modelled(), 0);
  EXPECT_THAT(html, HasSubstr("<b>68</b> MUL &lt;costs&gt; much <span class=faint>(lines <a "
                              "href=\"#p1-4\">4\xE2\x80\x93"
                              "5</a>, <a href=\"#p1-7\">7</a>)"));
  EXPECT_THAT(html, HasSubstr("ALU instructions: 70"));
  EXPECT_THAT(html, HasSubstr("TEX reads b, which MUL wrote in node 1"));
  EXPECT_THAT(html, HasSubstr("Longest chain of dependent reads (1)"));
  EXPECT_THAT(html, HasSubstr("<li><code>MUL b, a, a</code> line <a href=\"#p1-4\">4</a>, node 1"));
  EXPECT_THAT(html, HasSubstr("About 24.5 a pixel in one pipe, bound by <b>ALU</b> (ALU 24.5, "
                              "texture 4). <span class=faint>What it assumes and "
                              "leaves out: latency.</span>"));
  EXPECT_THAT(html, HasSubstr("node 0: &lt;r0&gt;"));
  EXPECT_THAT(html, HasSubstr("<tr id=p1-5 class=gone><td>5</td><td>gone</td>"));
  EXPECT_THAT(html, HasSubstr("<tr id=p1-6><td>6</td><td></td><td>1</td><td>2</td>"));
}

TEST(Section, LeavesOutWhatAReportLacks) {
  ProgramSet set = modelled();
  set.programs[0].file.native() = {};
  const std::string html = programSection(set, 0);
  for (const char *part :
       {"Why", "Texture nodes", "chain", "Cycles", "Disassembly", "slots", "gone"})
    EXPECT_THAT(html, Not(HasSubstr(part)));
  EXPECT_THAT(html, HasSubstr("<tr id=p1-3><td>3</td><td>TEX a,"));
}

TEST(Section, NumbersThatAreNoInstructionsAreLeftOut) {
  ProgramSet set = modelled();
  fp::hw::NativeReport &native = set.programs[0].file.native();
  native.reasons[0].instructions = {1000};
  native.chain = {0, 1000, 3};
  native.nodes[1].textures = {1000};
  native.costs.resize(2);
  EXPECT_THAT(programSection(set, 0), HasSubstr("<b>68</b> MUL &lt;costs&gt; much</li>"));
}

TEST(SourceTable, DiagnosticsStandBelowTheirLine) {
  const CheckedFile file = programOf("x", "!!ARBfp1.0\nMOV result.color,\t\xE9<q>;\nEND").file;
  const std::string html = sourceTable(file, "p7");
  const std::size_t line = html.find("<tr id=p7-2>"), error = html.find("error: ");
  ASSERT_NE(error, std::string::npos) << html;
  EXPECT_LT(line, error);
  EXPECT_LT(error, html.find("<tr id=p7-3>"));
  EXPECT_THAT(html, HasSubstr("<i>\\xE9</i>&lt;q&gt;"));
  // An error of the whole program follows the last line.
  EXPECT_THAT(sourceTable(programOf("x", "!!ARBfp1.0\n").file, "p1"), HasSubstr("<tr id=p1-2>"));
}

TEST(Excesses, NameTheCardAndTheApi) {
  ReportedProgram program = modelled().programs[0];
  EXPECT_THAT(excesses(program), ElementsAre("ALU instructions 70 of 64"));
  program.file.result.counts.temporaries = 33; // only a warning if the driver loads the program
  EXPECT_THAT(excesses(program), ElementsAre("ALU instructions 70 of 64"));
  program.refused = true;
  EXPECT_THAT(excesses(program),
              ElementsAre("ALU instructions 70 of 64", "temporaries (by the API 33 of 32)"));
  program.refused = false;
  program.file.result.nativeCounts = {};
  EXPECT_THAT(excesses(program),
              ElementsAre("no count is over its limit, but the card cannot hold it"));
}

TEST(Verdict, OfWhatTheDriverRefuses) {
  std::string text = "!!ARBfp1.0\nTEMP a;\nMOV a, fragment.color;\n";
  for (int i = 0; i < 100; ++i)
    text += "MOV a, a;\n";
  const ReportedProgram program = programOf("x", text + "MOV result.color, a;\nEND");
  EXPECT_TRUE(program.refused);
  EXPECT_EQ(program.verdict, Verdict::Over); // the API refuses it
  EXPECT_THAT(excesses(program), testing::Contains(HasSubstr("ALU instructions")));
  text = "!!ARBfp1.0\nOPTION ARB_fog_linear;\nTEMP a;\nMOV a, fragment.color;\n";
  for (int i = 0; i < 60; ++i)
    text += "MOV a, a;\n";
  EXPECT_THAT(
      excesses(programOf("x", text + "ADD a, a, a;\nMOV result.color, a;\nEND")),
      ElementsAre("refused: ATI Radeon 9700 (r300) has 62 ALU instructions (64 less 2 for the fog "
                  "option), and this program needs 63"));
  EXPECT_FALSE(programOf("x", text + "MOV result.color, q;\nEND").refused);
  EXPECT_EQ(programOf("x", text + "MOV result.color, q;\nEND").verdict, Verdict::Invalid);
}

TEST(Page, TheLargestReasonsOfWhatDoesNotFit) {
  ProgramSet set = modelled();
  for (std::uint32_t i = 0; i < 10; ++i)
    set.programs[0].file.native().reasons.push_back(
        {&ResourceCounts::aluInstructions, 1, "small " + std::to_string(i), {}});
  std::string html = reportPage(set);
  html = html.substr(0, html.find("<h2>Program by program"));
  EXPECT_THAT(html, HasSubstr("<li>ALU instructions: 1 small 3</li>"));
  EXPECT_THAT(html, Not(HasSubstr("small 4")));
  EXPECT_THAT(html, HasSubstr("and 6 more reasons, <a href=\"#p1\">in its section</a>"));
  EXPECT_THAT(html, Not(HasSubstr("TEX indirections: ")));
}

TEST(Page, ASetOfEveryVerdict) {
  ProgramSet set = modelled();
  set.source = "a<b";
  set.programs.push_back(
      programOf("fits.vp", "!!ARBvp1.0\nMOV result.position, vertex.position;\nEND"));
  set.programs.push_back(programOf("wrong.fp", "!!ARBfp1.0\nMOV x, y;\nEND"));
  ReportedProgram &lost = set.programs.emplace_back();
  lost.file.name = lost.file.fault = "lost.fp: gone";
  lost.file.status = FileStatus::Unreadable;
  lost.verdict = verdictOf(lost);
  const std::string html = reportPage(set);
  EXPECT_THAT(html, HasSubstr("<h1>Programs of a&lt;b</h1>"));
  EXPECT_THAT(html, HasSubstr("<tr data-s=\"does not fit\"><td><a href=\"#p1\">water.fp</a>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"n over\"><b>70</b></td>"));
  EXPECT_THAT(html, HasSubstr("<td class=n>24.5</td></tr>"));
  EXPECT_THAT(html, HasSubstr("<li>ALU instructions: 68 MUL &lt;costs&gt; much (lines <a"));
  EXPECT_THAT(html, HasSubstr("ALU instructions of ARBfp1.0 programs"));
  EXPECT_THAT(html, HasSubstr("instructions of ARBvp1.0 programs"));
  EXPECT_THAT(html, HasSubstr("<tr data-s=\"unreadable\">"));
  EXPECT_THAT(html, Not(HasSubstr("draws")));
  const std::string json = reportJson(set);
  EXPECT_THAT(json, HasSubstr("\"over_native\": 1"));
  EXPECT_THAT(json, HasSubstr("\"slots\": 1.5"));
}

} // namespace
} // namespace arbiter::tools
