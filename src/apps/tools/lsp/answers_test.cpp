// Tests of the displayed native counts, with reports made by hand. A model may leave out any part
// of a report.
#include <gtest/gtest.h>

#include "apps/tools/lsp/answers.h"
#include "apps/tools/lsp/native_text.h"

namespace arbiter::tools::lsp {
namespace {

using fp::ResourceCounts;

constexpr const char *kText = "!!ARBfp1.0\nTEMP a;\nTEX a, fragment.texcoord, texture, 2D;\n"
                              "SIN a.x, a.x; ADD a, a, a;\nMOV result.color, a;\nEND\n";

fp::hw::Profile r300() { return *fp::hw::findBuiltin("r300"); }

/// A document whose native report is replaced by a given one.
struct Made {
  explicit Made(fp::hw::NativeReport native, const char *text = kText)
      : document("file:///a.fp", "arbfp", text, Encoding::Utf16),
        analysis(const_cast<Analysis &>(document.analysis(profile))) {
    analysis.native = std::move(native);
  }
  [[nodiscard]] View view() const { return {document, analysis, profile}; }

  fp::hw::Profile profile = r300();
  Document document;
  Analysis &analysis;
};

/// Returns a report on TEX, SIN, ADD, MOV with two nodes, one removed instruction, and ALU over its
/// limit.
fp::hw::NativeReport report() {
  fp::hw::NativeReport native;
  native.model = fp::NativeModel::R300;
  native.counts.aluInstructions = 70;
  native.counts.texInstructions = 1;
  native.counts.texIndirections = 2;
  native.costs = {{0, 1, 0, false}, {2.5, 0, 1, false}, {0.5, 0, 1, false}, {0, 0, 0, true}};
  native.nodes.resize(2);
  native.reasons = {{&ResourceCounts::aluInstructions, 3, "SIN is a polynomial", {1}},
                    {&ResourceCounts::aluInstructions, 1, "a copy to the result", {2, 3}},
                    {&ResourceCounts::texIndirections, 1, "no reason of what is over", {0}}};
  native.cycles = {4, {{"ALU", 4}}, "ALU", "an estimate"};
  return native;
}

std::uint32_t lineOf(const Json &json) { return json["range"]["start"]["line"]; }

TEST(Inlay, EachLineSaysWhatItTakes) {
  const Made made(report());
  const Json hints = inlayHints(made.view(), {0, std::uint32_t(made.document.text().size())});
  ASSERT_EQ(hints.size(), 4u);
  EXPECT_EQ(hints[0]["position"], (Json{{"line", 0}, {"character", 10}}));
  const std::string total = hints[0]["label"];
  EXPECT_NE(total.find("70/64 ALU instructions (over)"), std::string::npos) << total;
  EXPECT_NE(total.find("2/4 TEX indirections"), std::string::npos) << total;
  EXPECT_EQ(hints[1]["label"], "1 TEX, node 1");
  EXPECT_EQ(hints[1]["tooltip"], "no reason of what is over");
  EXPECT_EQ(hints[2]["label"], "3 slots, node 2"); // SIN and ADD are on one line
  EXPECT_EQ(hints[2]["tooltip"], "SIN is a polynomial\na copy to the result");
  EXPECT_EQ(hints[3]["label"], "gone");
}

TEST(Inlay, OnlyTheLinesThatAreAskedFor) {
  const Made made(report());
  const auto at = std::uint32_t(made.document.text().find("SIN"));
  const Json hints = inlayHints(made.view(), {at, at});
  ASSERT_EQ(hints.size(), 1u);
  EXPECT_EQ(hints[0]["position"]["line"], 3);
}

TEST(Inlay, AModelThatKnowsNoCostsGivesTheTotal) {
  fp::hw::NativeReport native;
  native.counts = {5, 4, 1, 1, 1, 0, 1, 0};
  native.fits = true;
  const Made made(native);
  EXPECT_EQ(inlayHints(made.view(), {0, 1000}).size(), 1u);
  EXPECT_EQ(diagnostics(made.view()), Json::array());
}

TEST(OverNative, EachReasonStandsAtItsFirstInstruction) {
  const Made made(report());
  const Json found = diagnostics(made.view());
  ASSERT_EQ(found.size(), 3u);
  for (const Json &one : found) {
    EXPECT_EQ(one["severity"], 2);
    EXPECT_EQ(one["code"], "over_native");
  }
  EXPECT_EQ(lineOf(found[0]), 0u);
  EXPECT_EQ(found[0]["message"], "over the native limit of r300: 70 of 64 ALU instructions");
  EXPECT_EQ(lineOf(found[1]), 3u);
  EXPECT_EQ(found[1]["message"],
            "SIN is a polynomial: 3 of the 70 ALU instructions, where r300 has 64");
  EXPECT_EQ(lineOf(found[2]), 3u);
  EXPECT_EQ(lineOf(found[2]["relatedInformation"][0]["location"]), 4u);
}

TEST(OverNative, AReportThatPointsNowhereIsOfTheHeader) {
  fp::hw::NativeReport native = report();
  const std::vector<std::uint32_t> many(40, 1);
  native.reasons = {{&ResourceCounts::aluInstructions, 70, "the whole program", {}},
                    {&ResourceCounts::aluInstructions, 40, "what many share", many},
                    {&ResourceCounts::aluInstructions, 1, "an instruction too far", {99}}};
  const Made made(native);
  for (const Json &one : diagnostics(made.view()))
    EXPECT_EQ(lineOf(one), 0u);
}

TEST(Hover, SaysWhatTheInstructionTakesHere) {
  const Made made(report());
  const auto at = std::uint32_t(made.document.text().find("SIN"));
  const std::string text = hover(made.view(), at)["contents"]["value"];
  EXPECT_NE(text.find("here: 2.5 slots, node 2"), std::string::npos) << text;
  EXPECT_NE(text.find("SIN is a polynomial"), std::string::npos) << text;
  const auto gone = std::uint32_t(made.document.text().find("MOV"));
  const std::string of = hover(made.view(), gone)["contents"]["value"];
  EXPECT_NE(of.find("here: gone"), std::string::npos) << of;
}

TEST(Costs, AreShort) {
  EXPECT_EQ(costText(0, 0), "no slot");
  EXPECT_EQ(costText(1, 0), "1 slot");
  EXPECT_EQ(costText(0.5, 2), "0.5 slots, 2 TEX");
  EXPECT_EQ(costText(0, 1), "1 TEX");
}

TEST(Costs, TheProgramOfEveryOpcodeLoads) {
  // An opcode whose program does not load would have no cost, without any error.
  for (const char *profile : {"r300", "nv30", "i915"})
    for (int i = 0; i < fp::ir::kOpcodeCount; ++i)
      EXPECT_TRUE(opcodeLoads(fp::ir::Opcode(i), *fp::hw::findBuiltin(profile)))
          << profile << " " << info(fp::ir::Opcode(i)).mnemonic;
}

} // namespace
} // namespace arbiter::tools::lsp
