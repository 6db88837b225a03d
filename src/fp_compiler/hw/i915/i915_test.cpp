#include "fp_compiler/hw/i915/i915.h"

#include "fp_compiler/hw/native_support.h"

namespace arbiter::fp::hw {
namespace {

using namespace testing;

// Slots for each opcode. Source: Mesa's i915_fragprog.c.
constexpr SlotRow kI915[] = {
    {"ABS o, a;", 1, 0},
    {"ADD o, a, b;", 1, 0},
    {"CMP o, a, b, k;", 1, 0},
    {"COS o, a.x;", 10, 0},
    {"SIN o, a.x;", 10, 0},
    {"SIN o, k.x;", 11, 0},
    {"DPH o, a, k;", 1, 0},
    {"DST o, a, k;", 1, 0},
    {"LIT o, a;", 5, 0},
    {"LRP o, a, b, k;", 2, 0},
    {"LRP o, k, b, l;", 4, 0},
    {"LRP o, a, k, l;", 3, 0},
    {"POW o, a.x, k.y;", 3, 0},
    {"SCS o, a.x;", 6, 0},
    {"SCS o.y, a.x;", 4, 0},
    {"SWZ o, a, -x,y,0,1;", 1, 0},
    {"XPD o, a, b;", 2, 0},
    {"XPD o, k, l;", 4, 0},
    {"MAD o, k, l, a;", 2, 0},
    {"MAD o, k, k, a;", 1, 0},
    {"FLR o, a;", 1, 0},
    {"TEX r, a, texture[0], 2D; MOV o, r;", 1, 1},
    {"TEX r, a.yxzw, texture[0], 2D; MOV o, r;", 2, 1},
    {"TEX r.x, a, texture[0], 2D; MOV o, r.x;", 2, 1},
    {"TEX r, k, texture[0], 2D; MOV o, r;", 2, 1},
    {"KIL a; MOV o, a;", 1, 1},
    {"KIL -a; MOV o, a;", 2, 1},
    {"MOV result.depth.z, a.x; MOV o, a;", 3, 0},
    // dead code is not dropped
    {"FRC r, a; MOV o, a;", 2, 0},
};
TEST(I915, Slots) { expectSlots("i915", kI915); }

TEST(I915, PhasesAndWhy) {
  const NativeReport report =
      explained("i915", "TEX r, a, texture[0], 2D;\nMUL r, r, k;\nTEX s, r, texture[1], 2D;\n"
                        "TEX t, b.yxzw, texture[2], 2D;\nTEX o, t, texture[3], 2D;");
  EXPECT_EQ(report.counts.texIndirections, 4u);
  ASSERT_EQ(report.nodes.size(), 4u);
  EXPECT_EQ(report.nodes[0].reason, "");
  EXPECT_EQ(report.nodes[1].reason, "TEX reads r, which MUL wrote in phase 1");
  EXPECT_EQ(report.nodes[2].reason, "TEX reads its coordinate, moved in phase 2");
  EXPECT_EQ(report.nodes[3].reason, "TEX samples into a result register");
  EXPECT_EQ(report.nodes[1].textures, std::vector<std::uint32_t>{2});
  EXPECT_EQ(report.nodes[1].pairs, 1u); // the move of b.yxzw
  EXPECT_EQ(report.costs[3].node, 2u);
  EXPECT_EQ(report.costs[3].slots, 1);
  EXPECT_EQ(report.costs[3].textures, 1u);
  EXPECT_TRUE(report.fits);
  EXPECT_FALSE(explained("i915", "TEX r, a, texture[0], 2D; TEX r, r, texture[0], 2D;"
                                 "TEX r, r, texture[0], 2D; TEX r, r, texture[0], 2D;"
                                 "TEX r, r, texture[0], 2D; MOV o, r;")
                   .fits);
}

TEST(I915, PositionTakesATextureCoordinate) {
  std::string body = "ADD r, fragment.position, a;";
  for (int i = 1; i < 7; ++i)
    body += "ADD r, r, fragment.texcoord[" + std::to_string(i) + "];";
  EXPECT_TRUE(explained("i915", body + "MOV o, r;").fits);
  EXPECT_FALSE(explained("i915", body + "ADD o, r, fragment.texcoord[7];").fits);
}

TEST(I915, Registers) {
  // The text has three registers. The moved coordinate uses a dead one if there is one.
  EXPECT_EQ(explained("i915", "MOV r, a; MOV s, a; ADD t, r, s; TEX r, b.yxzw, texture[0], 2D;"
                              "ADD o, r, t;")
                .counts.temporaries,
            3u);
  const NativeReport scratch =
      explained("i915", "MOV r, a; MOV s, a; MOV t, a; KIL b.yxzw; ADD r, r, s; ADD o, r, t;");
  EXPECT_EQ(scratch.counts.temporaries, 4u);
  ASSERT_NE(find(scratch, "a register for coordinates"), nullptr) << all(scratch);
}

} // namespace
} // namespace arbiter::fp::hw
