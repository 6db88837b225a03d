#include "apps/tools/debug/trace/compare.h"

#include <gtest/gtest.h>
#include <limits>

#include "apps/tools/debug/testing/fake_drawer.h"
#include "apps/tools/debug/trace/record.h"

namespace arbiter::tools::debug {
namespace {

Trace traced(const std::string &text) {
  const fp::ir::Program program = checked(text);
  TraceInputs inputs;
  inputs.attributes.assign(program.attributes.size(), {0.25f, 0.5f, 0.75f, 1});
  return record(program, text, inputs, {fp::Numerics::Host, fp::Numerics::Fp24});
}

/// Returns a program of 60 instructions, each with its own constant; line i + 3 has instruction i.
std::string sixty(int changed = -1, const char *constant = "") {
  std::string text = "!!ARBfp1.0\nTEMP a, b;\nMOV a, fragment.color;\n";
  for (int i = 1; i < 59; ++i) {
    const std::string k = i == changed ? constant : "0." + std::to_string(100 + 7 * i);
    text += i % 3 == 0   ? "MAD a, a, " + k + ", b;\n"
            : i % 3 == 1 ? "ADD b.xyz, a, " + k + ";\n"
                         : "MUL a.xw, b, " + k + ";\n";
  }
  return text + "ADD result.color, a, b;\nEND\n";
}

TEST(Compare, EqualTracesHaveNoDifference) {
  const Trace trace = traced(sixty());
  ASSERT_EQ(trace.rows.size(), 60u);
  EXPECT_FALSE(firstDifference(trace, trace, {}));
  EXPECT_FALSE(differingResult(trace, trace, {}));
}

TEST(Compare, EachPlantedConstantIsFoundWhereItStands) {
  const Trace right = traced(sixty());
  for (int i = 1; i < 59; ++i) {
    const Trace wrong = traced(sixty(i, "0.0625"));
    const auto difference = firstDifference(wrong, right, {});
    ASSERT_TRUE(difference) << i;
    EXPECT_EQ(difference->row, std::size_t(i));
    EXPECT_EQ(difference->other, std::size_t(i));
    EXPECT_NE(difference->cause.find("0.0625"), std::string::npos) << difference->cause;
  }
}

TEST(Compare, RowsThatWereAddedHaveNoPartner) {
  const std::string text = "!!ARBfp1.0\nTEMP a, b;\nMOV a, fragment.color;\nMUL b, a, 0.5;\n"
                           "ADD a, a, b;\nMOV result.color, a;\nEND\n";
  std::string longer = text;
  longer.insert(longer.find("ADD"), "RCP b.w, a.x;\nMOV b.w, a.x;\nMUL b.w, b.w, 0.5;\n");
  const Trace a = traced(text), b = traced(longer);
  EXPECT_EQ(align(a, b), (Pairs{{0, 0}, {1, 1}, {2, 5}, {3, 6}}));
  const auto difference = firstDifference(a, b, {});
  ASSERT_TRUE(difference) << "b.w is 0.125 there";
  EXPECT_EQ(difference->row, 2u);
  EXPECT_EQ(difference->other, 5u);
  EXPECT_EQ(difference->components, 0b1000);
  EXPECT_EQ(differingResult(a, b, {}), "result.color");
}

TEST(Compare, AnotherOpcodeInOnesPlaceIsPaired) {
  const std::string text = "!!ARBfp1.0\nTEMP a;\nMOV a, fragment.color;\nADD a, a, 0.5;\n"
                           "MOV result.color, a;\nEND\n";
  std::string other = text;
  other.replace(other.find("ADD"), 3, "SUB");
  const auto difference = firstDifference(traced(text), traced(other), {});
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->row, 1u);
  EXPECT_EQ(difference->cause, "the instruction is another: SUB a, a, 0.5");
}

TEST(Compare, KilThatDecidesDifferentlyDiffers) {
  const auto text = [](const char *bound) {
    return std::string("!!ARBfp1.0\nTEMP a;\nSUB a, fragment.color, ") + bound +
           ";\nKIL a;\nMOV result.color, 1.0;\nEND\n";
  };
  const auto difference = firstDifference(traced(text("0.25")), traced(text("0.3")), {1, 0});
  ASSERT_TRUE(difference) << "the tolerance hides the values";
  EXPECT_EQ(difference->row, 1u);
  EXPECT_EQ(difference->components, 0);
}

TEST(Compare, TolerancesAndWhatIsNoNumber) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(isEqual(kNan, kNan, {}));
  EXPECT_FALSE(isEqual(kNan, 0, {1e30f, 1}));
  EXPECT_TRUE(isEqual(kInf, kInf, {}));
  EXPECT_FALSE(isEqual(kInf, -kInf, {1, 1}));
  EXPECT_FALSE(isEqual(kInf, 1, {1, 1}));
  EXPECT_TRUE(isEqual(1, 1.5f, {0.5f, 0}));
  EXPECT_FALSE(isEqual(1, 1.5f, {0.25f, 0}));
  EXPECT_TRUE(isEqual(100, 101, {0, 0.01f}));
  EXPECT_EQ(differing({1, 2, 3, 4}, {1, 0, 3, 0}, 0b0011, {}), 0b0010);
}

TEST(Compare, LongUnlikeProgramsArePairedByNumber) {
  std::string a = "!!ARBfp1.0\nTEMP a;\n", b = a;
  for (int i = 0; i < 2100; ++i) {
    a += "ADD a.x, a, 1.0;\n";
    b += "MUL a.y, a, 1.0;\n";
  }
  a += "MOV result.color, a;\nEND\n";
  b += "MOV result.color, a;\nEND\n";
  const Pairs pairs = align(traced(a), traced(b));
  EXPECT_EQ(pairs.size(), 2101u);
  EXPECT_EQ(pairs[2000], (Pairs::value_type{2000, 2000}));
}

} // namespace
} // namespace arbiter::tools::debug
