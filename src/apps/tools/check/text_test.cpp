// Tests the text of `arbiter check` with reports made by hand, so that every part of a report is
// covered regardless of the models.
#include "apps/tools/check/text.h"

#include <gtest/gtest.h>

#include "apps/tools/check/compare.h"
#include "apps/tools/check/source_text.h"
#include "apps/tools/check/summary.h"
#include "apps/tools/check/why.h"

namespace arbiter::tools {
namespace {

using fp::ResourceCounts;

constexpr const char *kText = "!!ARBfp1.0\n"                                   // 1
                              "TEMP a, b;\n"                                   // 2
                              "TEX a, fragment.texcoord[0], texture[0], 2D;\n" // 3
                              "MUL b, a,   # twice\n"                          // 4
                              "  {2};\n"                                       // 5
                              "TEX a, b, texture[1], 2D;\n"                    // 6
                              "SIN b.x, a.x;\n"                                // 7
                              "MOV b.y, a.x;\n"                                // 8
                              "MOV result.color, b.x;\n"                       // 9
                              "END\n";

const fp::hw::Profile &r300() { return *fp::hw::findBuiltin("r300"); }

/// Returns the program of kText with a report of two nodes, over the card's ALU limit.
CheckedFile overFile() {
  CheckedFile file;
  file.name = "deep.fp";
  file.text = kText;
  file.limits = r300().fragment;
  file.result = fp::checkProgram(file.language, file.text, {file.limits});
  EXPECT_TRUE(file.result.ok());
  file.status = FileStatus::OverNative;
  fp::hw::NativeReport report;
  report.model = fp::NativeModel::R300;
  report.counts = file.result.counts;
  report.counts.aluInstructions = 70;
  report.reasons = {
      {&ResourceCounts::aluInstructions, 67, "SIN is a polynomial", {3}},
      {&ResourceCounts::aluInstructions, 3, "one slot each", {1, 4, 5}},
      {&ResourceCounts::texIndirections, 1, "TEX reads b, which MUL wrote", {1, 2}},
  };
  report.costs = {{0, 1, 0, false},  {0.5, 0, 0, false}, {0, 1, 1, false},
                  {67, 0, 1, false}, {0, 0, 0, true},    {1, 0, 1, false}};
  report.nodes = {{{0}, 1, ""}, {{2}, 69, "TEX reads b, which MUL wrote in node 1"}};
  report.chain = {0, 1, 2};
  report.cycles = {70,
                   {{"ALU", 70}, {"texture", 2.25}},
                   "ALU",
                   "no cache misses are counted, nor the time that filtering of more than one "
                   "sample takes, nor memory"};
  file.result.nativeCounts = report.counts;
  file.result.underNativeLimits = false;
  file.native() = std::move(report);
  return file;
}

Style ascii() { return {}; }

TEST(Text, TheReasonsStandUnderWhatIsOver) {
  EXPECT_EQ(fullText(overFile(), r300(), {ascii(), false}),
            R"(deep.fp: valid, but over the native limits of r300
  resource              used   limit  native   limit  API          native
  instructions             6      96       6      96  [#.........] [#.........]
  ALU instructions         4      64      70      64  [#.........] [#########>]  over the native limit
      67  SIN is a polynomial
            7 | SIN b.x, a.x
       3  one slot each
            4 | MUL b, a, {2}
            8 | MOV b.y, a.x
            9 | MOV result.color, b.x
  TEX instructions         2      32       2      32  [#.........] [#.........]
  TEX indirections         2       4       2       4  [#####.....] [#####.....]
  temporaries              2      32       2      32  [#.........] [#.........]
  parameters               1      32       1      32  [#.........] [#.........]
  attribs                  1      10       1      10  [#.........] [#.........]
  native: modelled (r300): 2 texture nodes, 1 dependent read, about 70 cycles a pixel, bound by ALU
)");
}

TEST(Text, WhyShowsNodesChainCyclesAndCosts) {
  const std::string text = fullText(overFile(), r300(), {ascii(), true});
  const std::size_t tail = text.find("  native: modelled");
  ASSERT_NE(tail, std::string::npos);
  EXPECT_NE(text.find("       1  TEX reads b, which MUL wrote\n"), std::string::npos)
      << "a resource that fits has its reasons too";
  EXPECT_EQ(text.substr(text.find('\n', tail) + 1), R"(  texture nodes:
    1   1 TEX, 1 ALU pair
            3 | TEX a, fragment.texcoord[0], texture[0], 2D
    2   1 TEX, 69 ALU pairs: TEX reads b, which MUL wrote in node 1
            6 | TEX a, b, texture[1], 2D
  the longest chain of dependent reads (1 read):
    node 1  *     3 | TEX a, fragment.texcoord[0], texture[0], 2D
            |     4 | MUL b, a, {2}
    node 2  *     6 | TEX a, b, texture[1], 2D
  cycles: about 70 a pixel in one pipe (ALU 70, texture 2.3), bound by ALU
    no cache misses are counted, nor the time that filtering of more than one sample takes, nor
    memory
  each instruction:
   slots  TEX  node
       0    1     1     3 | TEX a, fragment.texcoord[0], texture[0], 2D
     0.5    0     1     4 | MUL b, a, {2}
       0    1     2     6 | TEX a, b, texture[1], 2D
      67    0     2     7 | SIN b.x, a.x
       -    -     -     8 | MOV b.y, a.x  (nothing is left of it)
       1    0     2     9 | MOV result.color, b.x
)");
}

TEST(Text, ACardWithoutNodesHasNoColumnOfThem) {
  CheckedFile file = overFile();
  file.native().nodes.clear();
  const std::string text = fullText(file, r300(), {ascii(), true});
  EXPECT_NE(text.find("(1 read):\n    *     3 | TEX a"), std::string::npos) << text;
  EXPECT_NE(text.find("   slots  TEX\n       0    1     3 | TEX a"), std::string::npos) << text;
  EXPECT_EQ(text.find("node"), std::string::npos);
}

TEST(Text, MoreIndirectionsThanFitAreDrawn) {
  CheckedFile file = overFile();
  file.native().counts.texIndirections = file.result.nativeCounts.texIndirections = 5;
  const std::string text = fullText(file, r300(), {ascii(), false});
  EXPECT_NE(text.find("[#########>]  over the native limit\n       1  TEX reads b"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("  texture nodes:\n"), std::string::npos)
      << "the reasons stand below the indirections";
  EXPECT_NE(text.find("  the longest chain"), std::string::npos);
}

TEST(Text, OverBothLimitsSaysBoth) {
  CheckedFile file = overFile();
  file.result.counts.aluInstructions = 65;
  EXPECT_NE(fullText(file, r300(), {ascii(), false})
                .find("[#########>] [#########>]  over the API limit and the native limit\n"),
            std::string::npos);
}

TEST(Text, AnUnenforcedLimitIsNoneThatRefuses) {
  CheckedFile file = overFile();
  file.native() = {};
  file.result.counts.texIndirections = file.result.nativeCounts.texIndirections = 5;
  ASSERT_EQ(file.limits.refuseIndirections, 0u);
  const auto row = [&] {
    const std::string text = fullText(file, r300(), {ascii(), false});
    const std::size_t at = text.find("  TEX indirections");
    const std::size_t words = text.find("]  ", at) + 1;
    return text.substr(words, text.find('\n', at) - words);
  };
  EXPECT_EQ(row(), "  over the native limit; the API limit is not enforced");
  file.result.nativeCounts.texIndirections = 4;
  EXPECT_EQ(row(), "  over the API limit, which is not enforced");
  file.limits.refuseIndirections = 1;
  EXPECT_EQ(row(), "  over the API limit");
  file.result.nativeCounts.texIndirections = 5;
  EXPECT_EQ(row(), "  over the API limit and the native limit");
}

TEST(Text, ACardWithoutProgramsSaysThatAlone) {
  const fp::hw::Profile &card = *fp::hw::findBuiltin("nv25");
  CheckedFile file = overFile();
  file.limits = card.fragment;
  file.result.diagnostics = {
      {fp::Severity::Error, "limit_tex_indirections", {}, "more than 4 texture indirections", ""}};
  EXPECT_EQ(fullText(file, card, {ascii(), true}),
            "deep.fp: nv25: the card has no fragment programs\n");
  EXPECT_EQ(lackText(file, card), "deep.fp: nv25: the card has no fragment programs\n");
  EXPECT_EQ(briefText(file, ascii()), "");
  EXPECT_EQ(lackText(overFile(), r300()), "");
  // An error that holds for any card is still reported.
  file.status = FileStatus::Invalid;
  file.result.diagnostics = {{fp::Severity::Error, "syntax", {0, 1}, "wrong", ""}};
  EXPECT_NE(fullText(file, card, {ascii(), false}).find(": error: wrong [syntax]"),
            std::string::npos);
  Summary summary;
  summary.add(file);
  EXPECT_EQ(summary.tables(ascii()), "do not fit:\n  " + std::string(18, ' ') +
                                         "       -       -  deep.fp: the card has no fragment "
                                         "programs\n");
}

TEST(Text, ACardThatLeavesVertexProgramsToItsDriverIsNotOverLimits) {
  const fp::hw::Profile &card = *fp::hw::findBuiltin("i915");
  CheckedFile file;
  file.name = "v.vp";
  file.language = fp::ir::Language::ArbVertex;
  file.text = "!!ARBvp1.0\nMOV result.position, vertex.position;\nEND\n";
  file.limits = card.vertex;
  file.result = fp::checkProgram(file.language, file.text, {file.limits});
  file.status = FileStatus::OverNative;
  const std::string text = fullText(file, card, {ascii(), false});
  EXPECT_NE(text.find("v.vp: valid; the card has no vertex programs of its own: its driver runs "
                      "them on the processor\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("over the"), std::string::npos) << text;
}

TEST(Text, OverByWhatNoCountShowsGivesEveryReason) {
  CheckedFile file = overFile();
  file.native().counts = file.result.nativeCounts = file.result.counts;
  const std::string text = fullText(file, r300(), {ascii(), false});
  EXPECT_EQ(text.find("over the native limit\n"), std::string::npos);
  EXPECT_NE(text.find("SIN is a polynomial"), std::string::npos);
}

TEST(Text, TheTotalIsOverByItsParts) {
  CheckedFile file = overFile();
  file.native().counts = file.result.nativeCounts = file.result.counts;
  file.native().counts.instructions = file.result.nativeCounts.instructions = 97;
  const std::string text = fullText(file, r300(), {ascii(), false});
  EXPECT_NE(text.find("  over the native limit\n  ALU instructions"), std::string::npos) << text;
  EXPECT_NE(text.find("SIN is a polynomial"), std::string::npos);
  EXPECT_EQ(text.find("TEX reads b"), std::string::npos);
  Summary summary;
  summary.add(file);
  EXPECT_NE(summary.tables(ascii()).find("97      96  deep.fp: SIN is a polynomial (67)\n"),
            std::string::npos);
}

TEST(Text, AnEmptyReportIsDocumentedNumbers) {
  CheckedFile file = overFile();
  file.status = FileStatus::Valid;
  file.native() = fp::hw::NativeReport{};
  file.result.nativeCounts = file.native().counts = file.result.counts;
  const std::string text = fullText(file, r300(), {ascii(), true});
  EXPECT_TRUE(text.ends_with(
      "  native: documented, not modelled: the card's limits, the counts of the API\n"))
      << text;
  file.native().model = fp::NativeModel::Nv30;
  EXPECT_TRUE(fullText(file, r300(), {ascii(), true}).ends_with("  native: modelled (nv30)\n"));
}

TEST(Text, LongListsAreCutUnlessAskedFor) {
  CheckedFile file = overFile();
  file.native().reasons.clear();
  for (std::uint32_t i = 0; i < 11; ++i)
    file.native().reasons.push_back({&ResourceCounts::aluInstructions, 20 - i, "a cause", {}});
  file.native().reasons[0].instructions = {0, 1, 2, 3, 4, 5};
  const std::string some = fullText(file, r300(), {ascii(), false});
  EXPECT_NE(some.find("              and 3 more (--why)\n"), std::string::npos) << some;
  EXPECT_NE(some.find("          and 3 reasons more (--why)\n"), std::string::npos) << some;
  EXPECT_EQ(fullText(file, r300(), {ascii(), true}).find("(--why)"), std::string::npos);
}

TEST(Text, AnIndexPastTheProgramIsNoCrash) {
  CheckedFile file = overFile();
  file.native().reasons[0].instructions = {99};
  file.native().chain = {0, 99};
  file.native().nodes[1].textures = {99};
  EXPECT_NE(fullText(file, r300(), {ascii(), true}).find("SIN is a polynomial"), std::string::npos);
}

TEST(Gauge, FillsByTheCount) {
  EXPECT_EQ(gauge(0, 64, ascii()), "[..........]");
  EXPECT_EQ(gauge(1, 64, ascii()), "[#.........]") << "something is not nothing";
  EXPECT_EQ(gauge(63, 64, ascii()), "[#########.]") << "only a full count fills it";
  EXPECT_EQ(gauge(64, 64, ascii()), "[##########]");
  EXPECT_EQ(gauge(65, 64, ascii()), "[#########>]");
  EXPECT_EQ(gauge(0, 0, ascii()), "[..........]");
  EXPECT_EQ(gauge(1, 0, ascii()), "[#########>]");
  EXPECT_EQ(gauge(4294967295u, 4294967295u, ascii()), "[##########]");
  const Style blocks{true, true, false};
  EXPECT_EQ(gauge(0, 64, blocks), "··········");
  EXPECT_EQ(gauge(1, 1000000, blocks), "▏·········");
  EXPECT_EQ(gauge(1, 2, blocks), "█████·····");
  EXPECT_EQ(gauge(63, 64, blocks), "█████████▊");
  EXPECT_EQ(gauge(65, 64, blocks), "█████████>");
}

TEST(Gauge, ColorsSayHowClose) {
  const Style color{true, false, true};
  EXPECT_EQ(gauge(1, 2, color), "\x1b[32m[#####.....]\x1b[0m");
  EXPECT_EQ(gauge(95, 100, color), "\x1b[33m[#########.]\x1b[0m");
  EXPECT_EQ(gauge(101, 100, color), "\x1b[31m[#########>]\x1b[0m");
}

TEST(SourceText, AgreesWithLocate) {
  for (const std::string_view text :
       {"", "a", "a\nb", "a\r\nb\rc\n\rd", "\r", "\r\n", "\n\n", "x\ry\n"}) {
    const SourceText source(text);
    for (std::uint32_t at = 0; at <= text.size() + 2; ++at) {
      EXPECT_EQ(source.at(at).line, fp::locate(text, at).line) << text << " at " << at;
      EXPECT_EQ(source.at(at).column, fp::locate(text, at).column) << text << " at " << at;
    }
  }
}

TEST(SourceText, AStatementIsOnePrintableLine) {
  const std::string_view text = "  MUL a,\t# why; not\r\n\n  b ;\x1b[2J\xff";
  EXPECT_EQ(SourceText(text).statement({0, std::uint32_t(text.size())}, 40), "MUL a, b ;?[2J?");
  EXPECT_EQ(SourceText(text).statement({2, 99}, 10), "MUL a, ...");
  EXPECT_EQ(SourceText("").statement({0, 5}, 10), "");
}

TEST(Summary, TheFullestAndThoseThatDoNotFit) {
  Summary summary;
  summary.add(overFile());
  CheckedFile small = overFile();
  small.name = "a/small.fp";
  small.status = FileStatus::Valid;
  small.result.nativeCounts.aluInstructions = 4;
  small.result.nativeCounts.attribs = 9;
  summary.add(small);
  CheckedFile bad;
  bad.name = "bad\x1b.fp";
  bad.status = FileStatus::Invalid;
  bad.limits = r300().fragment;
  bad.result.diagnostics = {{fp::Severity::Error, "limit_tex_instructions", {}, "too many", ""}};
  summary.add(bad);
  EXPECT_EQ(summary.line(r300()),
            "3 files under r300: 1 valid, 1 over the native limits, 1 invalid\n");
  EXPECT_EQ(summary.tables({false, false, false}),
            R"(the fullest of 2 ARBfp1.0 programs:
  instructions             6      96  deep.fp
  ALU instructions        70      64  deep.fp
  TEX instructions         2      32  deep.fp
  TEX indirections         2       4  deep.fp
  temporaries              2      32  deep.fp
  parameters               1      32  deep.fp
  attribs                  9      10  a/small.fp
do not fit:
  ALU instructions        70      64  deep.fp: SIN is a polynomial (67)
  TEX instructions         -       -  bad\x1b.fp: too many
)");
  EXPECT_EQ(summary.exitCode(), 2);
  summary.addFault();
  EXPECT_EQ(summary.exitCode(), 1);
}

TEST(Summary, AReasonThatPointsSomewhereIsThere) {
  CheckedFile file = overFile();
  auto &reasons = file.native().reasons;
  reasons.insert(reasons.begin(), {&ResourceCounts::aluInstructions, 90, "the whole program", {}});
  const auto misfits = [&] {
    Summary summary;
    summary.add(file);
    const std::string text = summary.tables(ascii());
    return text.substr(text.find("do not fit:"));
  };
  EXPECT_NE(misfits().find("deep.fp: SIN is a polynomial (67)\n"), std::string::npos) << misfits();
  reasons.resize(1);
  EXPECT_NE(misfits().find("deep.fp: the whole program (90)\n"), std::string::npos) << misfits();
  reasons.clear();
  EXPECT_NE(misfits().find("70      64  deep.fp\n"), std::string::npos) << misfits();
}

TEST(Compare, CountsAndDifferences) {
  const Side a{overFile(), &r300()};
  Side b{overFile(), fp::hw::findBuiltin("nv30")};
  b.file.limits = b.profile->fragment;
  b.file.status = FileStatus::Valid;
  b.file.native() = fp::hw::NativeReport{};
  b.file.result.nativeCounts = b.file.result.counts;
  const std::string text = Comparison(a, b).text(ascii());
  EXPECT_NE(text.find("A: deep.fp: valid, but over the native limits of r300\n"
                      "B: deep.fp: valid, within the native limits of nv30\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("  ALU instructions           4/64       4/1024       0        70/64"
                      "       4/1024     -66\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("  texture nodes     " + std::string(46, ' ') + "2            -\n"),
            std::string::npos)
      << text;
  // A model without nodes can still report dependent reads and cycles.
  b.file.native() = a.file.native();
  b.file.native().nodes.clear();
  const std::string other = Comparison(a, b).text(ascii());
  EXPECT_NE(other.find("  texture nodes     " + std::string(46, ' ') + "2            -\n"),
            std::string::npos)
      << other;
  EXPECT_NE(other.find("1            1       0\n"), std::string::npos) << other;
  EXPECT_NE(other.find("70           70       0\n"), std::string::npos) << other;
}

} // namespace
} // namespace arbiter::tools
