// Tests of edits, costs and trials.
#include <gtest/gtest.h>

#include "apps/tools/advise/advise.h"
#include "apps/tools/advise/show.h"
#include "apps/tools/advise/trial.h"
#include "fp_compiler/hw/profile.h"

namespace arbiter::tools::advise {

namespace {

std::string edited(std::string_view text, Edits edits) {
  sort(edits);
  return applied(text, edits).value_or("overlap");
}

fp::Span spanOf(std::string_view text, std::string_view piece) {
  const std::size_t at = text.find(piece);
  return {std::uint32_t(at), std::uint32_t(at + piece.size())};
}

TEST(Edits, AreMadeTogether) {
  EXPECT_EQ(edited("abcdef", {{{4, 5}, "E"}, {{1, 3}, ""}, {{1, 1}, "-"}}), "a-dEf");
  EXPECT_EQ(edited("abc", {{{3, 3}, "d"}}), "abcd");
  EXPECT_EQ(edited("abc", {{{0, 2}, "x"}, {{1, 3}, "y"}}), "overlap");
  EXPECT_EQ(edited("abc", {{{2, 9}, "x"}}), "overlap");
}

TEST(Edits, KnowWhereAByteWas) {
  const Edits edits = {{{1, 3}, "long text"}, {{4, 4}, "++"}};
  EXPECT_EQ(before(edits, 0), 0u);
  EXPECT_FALSE(before(edits, 3)); // written
  EXPECT_EQ(before(edits, 10), 3u);
  EXPECT_FALSE(before(edits, 11));
  EXPECT_EQ(before(edits, 13), 4u);
}

TEST(Edits, RemoveALineOrAStatement) {
  const std::string_view lines = "A;\n  MUL a, b;  \nB;\n";
  EXPECT_EQ(edited(lines, {{wholeStatement(lines, spanOf(lines, "MUL a, b")), ""}}), "A;\nB;\n");
  const std::string_view one = "A; MUL a, b; B;";
  EXPECT_EQ(edited(one, {{wholeStatement(one, spanOf(one, "MUL a, b")), ""}}), "A;  B;");
  const std::string_view comment = "A;\nMUL a, b # not ; here\n ;\nB;\n";
  EXPECT_EQ(edited(comment, {{wholeStatement(comment, spanOf(comment, "MUL a, b")), ""}}),
            "A;\nB;\n");
  const std::string_view kept = "MUL a, b; # why\nB;\r\n";
  EXPECT_EQ(edited(kept, {{wholeStatement(kept, spanOf(kept, "MUL a, b")), ""}}), "# why\nB;\r\n");
}

TEST(Edits, InsertLinesAsTheTextHasThem) {
  const std::string_view lines = "A;\r\n  B;\r\n";
  EXPECT_EQ(edited(lines, {insertedBefore(lines, 6, {"X", "Y"})}),
            "A;\r\n  X;\r\n  Y;\r\n  B;\r\n");
  EXPECT_EQ(edited("A; B;", {insertedBefore("A; B;", 3, {"X"})}), "A; X; B;");
}

TEST(Costs, FallOnlyIfNoneGrows) {
  const Cost cost{10, 4, 2, true};
  EXPECT_TRUE(falls(cost, {9, 4, 2, true}));
  EXPECT_TRUE(falls(cost, {10, 4, 1, true}));
  EXPECT_FALSE(falls(cost, cost));
  EXPECT_FALSE(falls(cost, {5, 5, 2, true}));
  EXPECT_FALSE(falls(cost, {5, 4, 3, true}));
  EXPECT_FALSE(falls(cost, {9, 4, 2, false})) << "it fitted before";
  EXPECT_TRUE(fewerSlots(cost, {8, 5, 3, true}));
  EXPECT_FALSE(fewerSlots(cost, {9, 5, 2, true}));
  EXPECT_EQ(changeText(cost, {9, 4, 1, true}), "ALU 10 -> 9, nodes 2 -> 1");
}

constexpr const char *kHead = "!!ARBfp1.0\nTEMP t;\n";

bool equalTexts(const std::string &one, const std::string &other, Nearness nearness) {
  const Setting setting{fp::ir::Language::ArbFragment, fp::hw::findBuiltin("r300")->fragment};
  const std::string a = kHead + one + "\nEND\n", b = kHead + other + "\nEND\n";
  const auto x = Subject::read(a, setting), y = Subject::read(b, setting);
  return x && y && equal(x->program(), y->program(), {}, nearness);
}

// Each pair differs only at particular inputs, which the trial must find.
TEST(Trial, FindsDifferences) {
  constexpr Nearness kExact = Nearness::Exact, kRounding = Nearness::Rounding;
  const std::string sge = "SGE result.color, fragment.texcoord[0], program.local[0];";
  EXPECT_TRUE(equalTexts(sge, sge, kExact));
  EXPECT_FALSE(equalTexts(sge, "SLT result.color, program.local[0], fragment.texcoord[0];", kExact))
      << "equal numbers were not met";
  EXPECT_FALSE(equalTexts("MOV_SAT result.color, fragment.texcoord[0];",
                          "MAX result.color, fragment.texcoord[0], 0.0;", kRounding));
  EXPECT_FALSE(equalTexts("MOV result.color, fragment.color;",
                          "MOV result.color, fragment.color.xyzx;", kRounding));
  EXPECT_FALSE(equalTexts("TEX result.color, fragment.texcoord[0], texture[0], 2D;",
                          "TEX result.color, fragment.texcoord[0], texture[1], 2D;", kRounding));
  const std::string sum = "ADD t, fragment.texcoord[0], program.local[0];\n"
                          "ADD result.color, t, fragment.color;",
                    other = "ADD t, fragment.color, program.local[0];\n"
                            "ADD result.color, t, fragment.texcoord[0];";
  EXPECT_FALSE(equalTexts(sum, other, kExact));
  EXPECT_TRUE(equalTexts(sum, other, kRounding));
}

TEST(Trial, DoesNotAnswerOfWhatIsAlwaysDiscarded) {
  EXPECT_FALSE(equalTexts("KIL -1.0;\nMOV result.color, 1.0;", "KIL -1.0;\nMOV result.color, 0.0;",
                          Nearness::Rounding));
  EXPECT_FALSE(equalTexts("KIL fragment.texcoord[0];\nMOV result.color, 1.0;",
                          "KIL fragment.texcoord[1];\nMOV result.color, 1.0;", Nearness::Rounding));
}

TEST(Show, HasPlaceCostAndLines) {
  const std::string text = std::string(kHead) + "MUL t, fragment.color, 3.0;\nMAX t, t, 0.0;\n"
                                                "MIN result.color, t, 1.0;\nEND\n";
  const Setting setting{fp::ir::Language::ArbFragment, fp::hw::findBuiltin("r300")->fragment};
  const std::vector<Advice> all = advise(text, setting);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(lineText("a.fp:4:1: note", all[0]).find("a.fp:4:1: note: ALU 3 -> 1"), 0u);
  const std::string note = fp::render("a.fp", text, noteOf(all[0]));
  EXPECT_EQ(note.find("a.fp:4:1: note: MAX and MIN clamp"), 0u);
  const std::string full = fullText(note, text, all[0]);
  for (const char *piece :
       {"[clamp_by_sat]", "^~~~", "ALU 3 -> 1", "  - MAX t, t, 0.0;\n",
        "  - MUL t, fragment.color, 3.0;\n", "  + MUL_SAT t, fragment.color, 3.0;\n"})
    EXPECT_NE(full.find(piece), std::string::npos) << piece << " in\n" << full;
}

TEST(Show, StaysOnTheLineOfATextWithoutLines) {
  std::string text = "!!ARBfp1.0 TEMP t; MOV t, fragment.color; MUL t, t, 3.0; MAX t, t, 0.0; "
                     "MIN result.color, t, 1.0; END";
  const Setting setting{fp::ir::Language::ArbFragment, fp::hw::findBuiltin("r300")->fragment};
  const Fixed fixed = applyAll(text, setting);
  EXPECT_EQ(fixed.applied.size(), 1u);
  EXPECT_EQ(fixed.text.find('\n'), std::string::npos);
  const Advice first = advise(text, setting).at(0);
  EXPECT_LT(fullText(fp::render("a.fp", text, noteOf(first)), text, first).size(), 1500u);
}

} // namespace

} // namespace arbiter::tools::advise
