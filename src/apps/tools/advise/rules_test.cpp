#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>

#include "apps/tools/advise/advise.h"
#include "fp_compiler/hw/profile.h"

namespace arbiter::tools::advise {

namespace {

constexpr const char *kHead = "!!ARBfp1.0\nTEMP a, b, c, d;\nPARAM p = program.local[0];\n"
                              "PARAM q = program.local[1];\nATTRIB t = fragment.texcoord[0];\n"
                              "ATTRIB u = fragment.texcoord[1];\nATTRIB v = fragment.color;\n"
                              "OUTPUT o = result.color;\n";

std::string whole(const std::string &body) { return kHead + body + "\nEND\n"; }

Setting settingOf(const char *profile) {
  return {fp::ir::Language::ArbFragment, fp::hw::findBuiltin(profile)->fragment};
}

const Advice *find(const std::vector<Advice> &all, const char *rule) {
  for (const Advice &each : all)
    if (std::string_view(each.rule) == rule)
      return &each;
  return nullptr;
}

struct Row {
  const char *rule;
  bool fix;            ///< false: advice
  const char *profile; ///< the profile under which the rule lowers the cost
  const char *body;
  const char *silent; ///< a similar program to which the rule must not apply
};

// Each silent program differs from the other one in the rule's condition.
constexpr Row kRows[] = {
    {"constant_work", true, "r300", "PARAM k = {4, 0, 0, 0};\nRSQ a.x, k.x;\nMUL o, v, a.x;",
     "PARAM k = {0, 0, 0, 0};\nRSQ a.x, k.x;\nMUL o, v, a.x;"},
    {"constant_chain", true, "r300",
     "MAD a, v, {3, 4, 5, 6}, 0.5;\nMUL o, a, {0.1, 0.2, 0.3, 0.4};",
     "MAD_SAT a, v, {3, 4, 5, 6}, 0.5;\nMUL o, a, {0.1, 0.2, 0.3, 0.4};"},
    {"parameter_work", false, "r300", "RCP a.x, p.x;\nMUL o, v, a.x;",
     "RCP a.x, v.x;\nMUL o, v, a.x;"},
    {"linear_work", false, "r300", "ADD a, t, p;\nTEX o, a, texture[0], 2D;",
     "MUL a, t, u;\nTEX o, a, texture[0], 2D;"},
    {"component_order", false, "r300", "MUL o, v, p.yxzw;", "MUL o, v, p.yzxw;"},
    {"swizzles_by_one_copy", true, "r300",
     "ADD a.xy, v, p.wyww;\nADD b.xy, v, -p.wyww;\nADD c.xy, v, p.zyww;\nADD d.xy, v, -p.zyww;\n"
     "MUL a.xy, a, b;\nMUL c.xy, c, d;\nMAD o, a.xyxy, c.xyxy, v;",
     "ADD a.xy, v, p.wyww;\nADD b.xy, v, -p.xyww;\nADD c.xy, v, p.xyww;\nADD d.xy, v, -p.xyww;\n"
     "MUL a.xy, a, b;\nMUL c.xy, c, d;\nMAD o, a.xyxy, c.xyxy, v;"},
    {"table_of_one_value", false, "r300",
     "TEX a, t, texture[0], 2D;\nPOW a.x, a.x, p.x;\nSIN a.x, a.x;\nMOV o, a.x;",
     "TEX a, t, texture[0], 2D;\nPOW a.x, a.x, v.x;\nMOV o, a.x;"},
    {"unit_vector_cube_map", false, "r300",
     "DP3 a.w, u, u;\nRSQ a.w, a.w;\nMUL a.xyz, u, a.w;\nDP3 o, a, v;",
     "DP3 a.w, u, t;\nRSQ a.w, a.w;\nMUL a.xyz, u, a.w;\nDP3 o, a, v;"},
    {"clamp_by_sat", true, "r300", "MUL a, t, 3.0;\nMAX a, a, 0.0;\nMIN o, a, 1.0;",
     "MUL a, t, 3.0;\nMAX a, a, 0.0;\nMIN o, a, 2.0;"},
    {"sine_and_cosine", true, "r300",
     "FRC a.x, t.x;\nMAD a.x, a.x, 6.28, -3.14;\nSIN b.x, a.x;\nCOS c.x, a.x;\nMUL o, b.x, c.x;",
     "FRC a.x, t.x;\nMAD a.x, a.x, 6.28, -3.14;\nSIN b.x, a.x;\nCOS c.x, t.x;\nMUL o, b.x, c.x;"},
    {"sine_and_cosine", false, "r300", "SIN b.x, t.x;\nCOS c.x, t.x;\nMUL o, b.x, c.x;",
     "SIN b.x, t.x;\nCOS c.x, t.y;\nMUL o, b.x, c.x;"},
    {"select_by_cmp", true, "r300", "SGE a, t, p;\nMUL o, a, u;", "SGE a, t, p;\nADD o, a, u;"},
    {"opposite_comparison", true, "r300", "SGE a, t, p;\nSUB o, 1.0, a;",
     "SGE a, t, p;\nSUB o, 2.0, a;"},
    {"power_by_products", true, "r300", "PARAM k = {2};\nMOV_SAT a, t;\nPOW o, a.x, k.x;",
     "PARAM k = {2.5};\nMOV_SAT a, t;\nPOW o, a.x, k.x;"},
    {"power_by_products", false, "r300", "PARAM k = {2};\nPOW o, t.x, k.x;", "POW o, t.x, p.x;"},
    {"sum_by_dot_product", true, "r300",
     "MUL a.x, v.x, 0.3;\nMAD a.x, v.y, 0.59, a.x;\nMAD o.x, v.z, 0.11, a.x;",
     "MUL a.x, v.x, 0.3;\nMAD o.x, t.z, 0.11, a.x;"},
    {"scalars_to_vector", true, "nv30", "ADD a.x, t.x, p.x;\nADD b.x, t.y, p.y;\nMUL o, a.x, b.x;",
     "ADD a.x, t.x, p.x;\nADD b.x, a.x, p.y;\nMUL o, a.x, b.x;"},
    {"repeated_work", true, "r300", "MUL a, t, u;\nMUL b, t, u;\nMAX b, b, p;\nMIN o, a, b;",
     "MOV d, t;\nMUL a, d, u;\nMUL d, d, p;\nMUL b, d, u;\nMAX b, b, p;\nMIN o, a, b;"},
    {"needless_copy", true, "host", "MOV a, t;\nMUL o, a, p;", "MOV_SAT a, t;\nMUL o, a, p;"},
    {"dead_work", true, "host", "MUL a, t, p;\nMOV o, v;", "MUL a, t, p;\nMOV o, a;"},
    {"multiply_add", true, "host", "MUL a, t, p;\nADD o, a, u;",
     "MUL a, t, p;\nADD b, a, u;\nMUL o, a, b;"},
    {"homogeneous_dot_product", true, "r300", "DP3 a.x, v, p;\nADD o, a.x, p.w;",
     "DP3 a.x, v, p;\nADD o, a.x, q.w;"},
    {"linear_blend", true, "host", "SUB a, t, u;\nMAD o, p, a, u;",
     "SUB a, t, v;\nMAD o, p, a, u;"},
    {"operand_without_effect", true, "r300", "RCP a.x, t.x;\nMUL a, a.x, 1.0;\nMIN o, a, t;",
     "RCP a.x, t.x;\nMUL a, a.x, 1.5;\nMIN o, a, t;"},
    {"sample_earlier", true, "host",
     "TEX a, t, texture[0], 2D;\nMUL b, a, p;\nTEX a, u, texture[1], 2D;\nMUL o, a, b;",
     "TEX a, t, texture[0], 2D;\nMUL b, a, p;\nTEX a, b, texture[1], 2D;\nMUL o, a, b;"},
    {"kil_place", true, "host",
     "TEX a, t, texture[0], 2D;\nSUB b, a, p;\nKIL b;\nMUL c, a, p;\nTEX c, c, texture[1], 2D;\n"
     "MOV o, c;",
     "TEX a, t, texture[0], 2D;\nSUB b, a, p;\nKIL b;\nMOV o, a;"},
};

class Rules : public testing::TestWithParam<Row> {};

TEST_P(Rules, AreSaidWhereTheyGain) {
  const Row &row = GetParam();
  const std::string text = whole(row.body);
  const Setting setting = settingOf(row.profile);
  ASSERT_TRUE(Subject::read(text, setting)) << text;
  const std::vector<Advice> all = advise(text, setting);
  const Advice *found = find(all, row.rule);
  ASSERT_NE(found, nullptr) << row.rule << " is not said of\n" << text;
  EXPECT_EQ(found->isFix(), row.fix);
  EXPECT_EQ(found->isFix(), found->application.empty() && found->condition.empty());
  EXPECT_LT(found->after.slots() + found->after.nodes, found->before.slots() + found->before.nodes);
}

TEST_P(Rules, AreSilentWhereTheyDoNotHold) {
  const Row &row = GetParam();
  const std::string text = whole(row.silent);
  const Setting setting = settingOf(row.profile);
  ASSERT_TRUE(Subject::read(text, setting)) << text;
  const std::vector<Advice> all = advise(text, setting);
  const Advice *found = find(all, row.rule);
  EXPECT_EQ(found, nullptr) << row.rule << " is said of\n" << text;
}

INSTANTIATE_TEST_SUITE_P(All, Rules, testing::ValuesIn(kRows),
                         [](const testing::TestParamInfo<Row> &row) {
                           std::string name = row.param.rule;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name + (row.param.fix ? "_fix" : "_advice");
                         });

TEST(Rules, HaveAnExampleEach) {
  for (const RuleInfo &rule : ruleList())
    EXPECT_TRUE(std::any_of(std::begin(kRows), std::end(kRows), [&](const Row &row) {
      return std::string_view(row.rule) == rule.id;
    })) << rule.id;
}

TEST(Rules, AreInTheDocumentation) {
  std::ifstream file(ARBITER_SOURCE_ROOT "/docs/write/advice.md");
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  for (const RuleInfo &rule : ruleList())
    EXPECT_NE(page.find("| `" + std::string(rule.id) + "` |"), std::string::npos) << rule.id;
}

/// A program, a rule, and its slots and nodes before and after the rule.
struct Gain {
  const char *rule;
  const char *body;
  std::uint32_t slots, nodes, slotsAfter, nodesAfter;
};

// The gains for which the rules were made, on the R300. Slots include ALU and texture slots.
constexpr Gain kGains[] = {
    {"parameter_work", "DP3 a.w, p, p;\nRSQ a.w, a.w;\nMUL a.xyz, p, a.w;\nDP3 o, a, v;", 4, 1, 1,
     1},
    {"parameter_work", "RCP a.x, p.x;\nMUL o, v, a.x;", 2, 1, 1, 1},
    {"linear_work", "ADD a, t, p;\nTEX o, a, texture[0], 2D;", 3, 2, 2, 1},
    {"clamp_by_sat", "MUL a, t, 3.0;\nMAX a, a, 0.0;\nMIN o, a, 1.0;", 3, 1, 1, 1},
    {"sine_and_cosine", "SIN a.x, t.x;\nCOS a.y, t.x;\nMUL o, a.x, a.y;", 8, 1, 6, 1},
    {"select_by_cmp", "SGE a, t, p;\nMUL o, a, u;", 2, 1, 1, 1},
    {"component_order", "MUL o, v, p.yxzw;", 3, 1, 1, 1},
    {"component_order", "TEX o, t.yxzw, texture[0], 2D;", 4, 2, 2, 1},
};

TEST(Rules, GainWhatTheyWereMadeFor) {
  for (const Gain &gain : kGains) {
    const std::vector<Advice> all = advise(whole(gain.body), settingOf("r300"));
    const Advice *found = find(all, gain.rule);
    ASSERT_NE(found, nullptr) << gain.body;
    EXPECT_EQ(found->before.slots(), gain.slots) << gain.body;
    EXPECT_EQ(found->before.nodes, gain.nodes) << gain.body;
    EXPECT_EQ(found->after.slots(), gain.slotsAfter) << gain.body;
    EXPECT_EQ(found->after.nodes, gain.nodesAfter) << gain.body;
  }
}

// An improvement that the model makes itself must not be suggested, because it would gain nothing.
TEST(Rules, SayNothingThatTheModelDoes) {
  for (const char *body :
       {"MUL a, t, p;\nADD o, a, u;", "MOV a, t;\nMUL o, a, p;", "MUL a, t, p;\nMOV o, v;",
        "LG2 a.x, v.x;\nMUL a.x, a.x, p.x;\nEX2 o, a.x;"})
    for (const Advice &each : advise(whole(body), settingOf("r300")))
      EXPECT_FALSE(each.isFix()) << each.rule << " of\n" << body;
}

TEST(Rules, AreForTextsThatLoad) {
  EXPECT_TRUE(advise("!!ARBfp1.0\nMOV result.color, q;\nEND\n", settingOf("r300")).empty());
  EXPECT_TRUE(advise("", settingOf("r300")).empty());
  Setting ati = settingOf("r300");
  ati.language = fp::ir::Language::AtiFragment;
  EXPECT_TRUE(advise("!!ATIfs1.0\nStartOutputPass;\nMOV r0, color0;\nEndPass;\n", ati).empty());
}

} // namespace

} // namespace arbiter::tools::advise
