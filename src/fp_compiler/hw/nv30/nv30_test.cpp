#include "fp_compiler/hw/nv30/nv30.h"

#include "fp_compiler/hw/native_support.h"

namespace arbiter::fp::hw {
namespace {

using namespace testing;

// NV_fragment_program table X.4: an instruction of the chip is a slot. Other opcodes take several.
constexpr SlotRow kNv30[] = {
    {"ABS o, a;", 1, 0},
    {"ADD o, a, k;", 1, 0},
    {"CMP o, a, b, k;", 3, 0},
    {"COS o, a.x;", 1, 0},
    {"DP3 o, a, k;", 1, 0},
    {"DP4 o, a, k;", 1, 0},
    {"DPH o, a, k;", 2, 0},
    {"DST o, a, k;", 1, 0},
    {"EX2 o, a.x;", 1, 0},
    {"FLR o, a;", 1, 0},
    {"FRC o, a;", 1, 0},
    {"LG2 o, a.x;", 1, 0},
    {"LIT o, a;", 1, 0},
    {"LRP o, a, k, a.y;", 1, 0},
    {"MAD o, a, k, k.x;", 1, 0},
    {"MAX o, a, k;", 1, 0},
    {"MIN o, a, k;", 1, 0},
    {"MOV o, a;", 1, 0},
    {"MUL o, a, -k.wzyx;", 1, 0},
    {"POW o, a.x, k.y;", 1, 0},
    {"RCP o, a.x;", 1, 0},
    {"RSQ o, a.x;", 1, 0},
    {"SCS o, a.x;", 2, 0},
    {"SCS o.x, a.x;", 1, 0},
    {"SGE o, a, k;", 1, 0},
    {"SIN o, a.x;", 1, 0},
    {"SLT o, a, k;", 1, 0},
    {"SUB o, a, k;", 1, 0},
    {"SWZ o, a, x,y,0,1;", 1, 0},
    {"SWZ o, k, x,y,0,1;", 2, 0},
    {"XPD o, a, k;", 2, 0},
    {"TEX o, a.yxzw, texture[0], 2D;", 0, 1},
    {"KIL a; MOV o, a;", 2, 1},
    {"TXB o.x, -k, texture[0], 2D;", 0, 1},
    // one attribute and one constant register an instruction
    {"ADD o, a, b;", 2, 0},
    {"MAD o, k, l, a;", 2, 0},
    {"MAD o, k, l, k;", 2, 0},
    {"MAD o, a, b, a.x;", 2, 0},
    // fragment.fogcoord has no w
    {"MOV o, fragment.fogcoord;", 2, 0},
    {"MOV o, fragment.fogcoord.x;", 1, 0},
    // dead code is dropped
    {"SIN r, a.x; MOV o, a;", 1, 0},
};
TEST(Nv30, Slots) {
  expectSlots("nv30", kNv30);
  expectSlots("nv35", kNv30);
}

TEST(Nv30, RegistersAreThoseThatAreLiveAndHalvesShareOne) {
  const std::string body = "MOV r, a; MOV s, a; MOV t, a; ADD r, r, s; ADD r, r, t; MOV o, r;";
  EXPECT_EQ(explained("nv30", body).counts.temporaries, 3u);
  const std::string text = whole(body);
  const std::string fast =
      "!!ARBfp1.0\nOPTION ARB_precision_hint_fastest;" + text.substr(text.find('\n'));
  const CheckResult result = checked("nv30", fast);
  EXPECT_EQ(result.nativeCounts.temporaries, 2u);
}

TEST(Nv30, ReasonsNameTheInstructions) {
  const NativeReport report = explained(
      "nv30",
      "SCS r, a.x;\nMAD r, k, l, r;\nADD r, r, b;\nCMP r, r, a, b;\nSIN s, r.x;\nMOV o, r;");
  const Reason *scs = find(report, "SCS is a COS and a SIN");
  ASSERT_NE(scs, nullptr) << all(report);
  EXPECT_EQ(scs->amount, 2u);
  EXPECT_EQ(scs->instructions, std::vector<std::uint32_t>{0});
  const Reason *moved = find(report, "one constant an instruction: another is moved to a register");
  ASSERT_NE(moved, nullptr) << all(report);
  EXPECT_EQ(moved->amount, 1u);
  EXPECT_EQ(moved->instructions, std::vector<std::uint32_t>{1});
  EXPECT_TRUE(report.costs[4].gone);
  EXPECT_EQ(report.costs[3].slots, 3);
  EXPECT_TRUE(report.nodes.empty());
  EXPECT_EQ(report.model, NativeModel::Nv30);
}

// Beyond3D's measurements: a pass an instruction, two passes for LRP, RSQ, LIT and POW, and one
// pass for two samples of interpolated coordinates.
TEST(Nv30, Cycles) {
  const auto cycles = [](const char *profile, const char *body) {
    return explained(profile, body).cycles;
  };
  EXPECT_EQ(cycles("nv30", "ADD r, a, k; MUL o, r, r;").cycles, 2);
  EXPECT_EQ(cycles("nv30", "RSQ r, a.x; MUL o, r.x, a;").cycles, 3);
  EXPECT_EQ(
      cycles("nv30", "TEX r, a, texture[0], 2D; TEX s, b, texture[1], 2D; ADD o, r, s;").cycles, 2);
  EXPECT_EQ(cycles("nv30", "TEX r, a, texture[0], 2D; TEX r, r, texture[1], 2D; MOV o, r;").cycles,
            3);
  EXPECT_EQ(cycles("nv35", "ADD r, a, k; MUL o, r, r;").cycles, 1);
  const CycleEstimate bound =
      cycles("nv35", "TEX r, a, texture[0], 2D; TEX r, r, texture[1], 2D; MOV o, r;");
  EXPECT_EQ(bound.cycles, 2);
  EXPECT_EQ(bound.bound, "texture");
  EXPECT_EQ(cycles("nv30", "MOV r, a; MOV s, b; MOV t, k; ADD r, r, s; ADD o, r, t;").bound,
            "registers");
  EXPECT_FALSE(bound.limits.empty());
}

} // namespace
} // namespace arbiter::fp::hw
