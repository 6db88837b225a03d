#include "fp_compiler/hw/native.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/dataflow.h"
#include "fp_compiler/hw/i915/i915.h"
#include "fp_compiler/hw/nv30/nv30.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/testing/random.h"

namespace arbiter::fp::hw {
namespace {

constexpr std::string_view kHead = "!!ARBfp1.0\nTEMP r, s, t, u; PARAM k = {1, 2, 3, 4};\n"
                                   "PARAM l = {5, 6, 7, 8}; ATTRIB a = fragment.texcoord[0];\n"
                                   "ATTRIB b = fragment.texcoord[1]; OUTPUT o = result.color;\n";

CheckResult checked(std::string_view profile, const std::string &text) {
  CompileOptions options{findBuiltin(profile)->fragment, LimitPolicy::Report};
  CheckResult result = checkFragmentProgram(text, options);
  EXPECT_TRUE(result.ok()) << text << result.errorString(text);
  return result;
}

std::string whole(std::string_view body) {
  return std::string(kHead) + std::string(body) + "\nEND";
}

NativeReport explained(std::string_view profile, std::string_view body) {
  const std::string text = whole(body);
  const CheckResult result = checked(profile, text);
  return explainNative(result.program.value(), result.counts, findBuiltin(profile)->fragment);
}

struct Row {
  const char *body;
  std::uint32_t alu, tex;
};

void expectSlots(std::string_view profile, std::span<const Row> rows) {
  for (const Row &row : rows) {
    const ResourceCounts counts = explained(profile, row.body).counts;
    EXPECT_EQ(counts.aluInstructions, row.alu) << profile << ": " << row.body;
    EXPECT_EQ(counts.texInstructions, row.tex) << profile << ": " << row.body;
    EXPECT_EQ(counts.instructions, row.alu + row.tex) << profile << ": " << row.body;
  }
}

const Reason *find(const NativeReport &report, std::string_view text) {
  for (const Reason &reason : report.reasons)
    if (reason.text == text)
      return &reason;
  return nullptr;
}

std::string all(const NativeReport &report) {
  std::string text;
  for (const Reason &reason : report.reasons)
    text += std::to_string(reason.amount) + " " + reason.text + "\n";
  return text;
}

// NV_fragment_program table X.4: an instruction of the chip is a slot; the rest is made of them.
constexpr Row kNv30[] = {
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

// Mesa's i915_fragprog.c, opcode by opcode.
constexpr Row kI915[] = {
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
    // it translates what it is given
    {"FRC r, a; MOV o, a;", 2, 0},
};
TEST(I915, Slots) { expectSlots("i915", kI915); }

TEST(Models, FogIsInstructions) {
  constexpr std::pair<const char *, std::pair<std::uint32_t, std::uint32_t>> kModes[] = {
      {"linear", {4, 5}}, {"exp", {5, 6}}, {"exp2", {6, 7}}};
  for (const auto &[mode, slots] : kModes) {
    const std::string text = "!!ARBfp1.0\nOPTION ARB_fog_" + std::string(mode) +
                             ";\nMOV result.color, fragment.color;\nEND";
    const ResourceCounts nv30 = checked("nv30", text).nativeCounts;
    const ResourceCounts i915 = checked("i915", text).nativeCounts;
    EXPECT_EQ(nv30.aluInstructions, slots.first) << mode;
    EXPECT_EQ(i915.aluInstructions, slots.second) << mode;
    EXPECT_EQ(nv30.attribs, 2u);
    EXPECT_EQ(i915.attribs, 2u);
    EXPECT_EQ(nv30.parameters, 2u);
    EXPECT_EQ(i915.parameters, 2u);
  }
}

TEST(R300, PositionAndFogTakeTextureCoordinates) {
  std::string body = "ADD r, a, b;\n";
  for (int i = 2; i < 8; ++i)
    body += "ADD r, r, fragment.texcoord[" + std::to_string(i) + "];\n";
  EXPECT_TRUE(explained("r300", body + "ADD o, r, fragment.color;").fits);
  for (const char *ninth : {"fragment.position", "fragment.fogcoord"}) {
    const NativeReport report = explained("r300", body + "ADD o, r, " + ninth + ";");
    EXPECT_FALSE(report.fits) << ninth;
    EXPECT_EQ(report.counts.attribs, 9u) << "no count says so";
    EXPECT_NE(find(report, "position and fog take a texture coordinate's interpolator each: 9 of 8 "
                           "are needed"),
              nullptr)
        << all(report);
  }
}

TEST(R300, RectanglesAreScaledIfTheProfileSaysSo) {
  const std::string text = whole("TEX r, a, texture[0], RECT; MOV o, r;");
  Limits limits = findBuiltin("r300")->fragment;
  const auto counts = [&](std::uint32_t scale) {
    limits.scaleRectangles = scale;
    return checkFragmentProgram(text, {limits, LimitPolicy::Report}).nativeCounts;
  };
  EXPECT_EQ(counts(1).texIndirections, 2u);
  EXPECT_EQ(counts(1).parameters, 1u);
  EXPECT_EQ(counts(0).texIndirections, 1u);
  EXPECT_EQ(counts(0).parameters, 0u);
}

TEST(R300, TheSameCodeFitsTheR420) {
  std::string body = "MOV r, a;\n";
  for (int i = 0; i < 70; ++i)
    body += "MAD r, r, k, r.yzxw;\n";
  const NativeReport small = explained("r300", body + "MOV o, r;");
  const NativeReport large = explained("r420", body + "MOV o, r;");
  EXPECT_EQ(small.counts, large.counts);
  EXPECT_GT(small.counts.aluInstructions, 64u);
  EXPECT_FALSE(small.fits);
  EXPECT_TRUE(large.fits);
}

// A shared slot is a half of each operation; the whole numbers of the reasons add up all the same.
TEST(R300, PartsOfSharedSlots) {
  const NativeReport report = explained("r300", "MUL r.xyz, a, k;\nRCP r.w, b.x;\nMOV o, r;");
  EXPECT_EQ(report.costs[1].slots, 0.5);
  const Reason *single = find(report, "instructions of one slot");
  ASSERT_NE(single, nullptr) << all(report);
  EXPECT_EQ(single->amount, report.counts.aluInstructions) << all(report);
}

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
  // Three registers of the text; the moved coordinate finds a dead one where there is one.
  EXPECT_EQ(explained("i915", "MOV r, a; MOV s, a; ADD t, r, s; TEX r, b.yxzw, texture[0], 2D;"
                              "ADD o, r, t;")
                .counts.temporaries,
            3u);
  const NativeReport scratch =
      explained("i915", "MOV r, a; MOV s, a; MOV t, a; KIL b.yxzw; ADD r, r, s; ADD o, r, t;");
  EXPECT_EQ(scratch.counts.temporaries, 4u);
  ASSERT_NE(find(scratch, "a register for coordinates"), nullptr) << all(scratch);
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

// Beyond3D's measurements: a pass an instruction, two for LRP, RSQ, LIT and POW, two samples of
// interpolated coordinates in one.
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

TEST(Dataflow, TheLongestChainLeavesDeadCodeAndOtherComponentsOut) {
  const CheckResult result =
      checked("host", whole("TEX r, a, texture[0], 2D;\n"   // 0
                            "MUL s, r, k;\n"                // 1
                            "TEX t, s, texture[1], 2D;\n"   // 2
                            "TEX u, t, texture[2], 2D;\n"   // 3: dead
                            "TEX u.x, b, texture[3], 2D;\n" // 4
                            "MOV u.yzw, r;\n"               // 5
                            "TEX u, u.x, texture[4], 1D;\n" // 6: after 4 alone
                            "ADD o, t, u;"));
  const Dataflow flow = dataflowOf(*result.program);
  EXPECT_EQ(longestChain(*result.program, flow), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_FALSE(flow.live[3]);
  EXPECT_TRUE(flow.live[4]);
  EXPECT_FALSE(flow.live[5]) << "the last sample reads x alone";
  EXPECT_EQ(flow.writers[6][0][0], 4u);
  const CheckResult flat = checked("host", whole("TEX r, a, texture[0], 2D; MOV o, r;"));
  EXPECT_TRUE(longestChain(*flat.program, dataflowOf(*flat.program)).empty());
}

// The parts of each count add up to it, and the fast way gives what the explained one does.
TEST(Models, CountsAreThoseOfTheReportOnRandomPrograms) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    testing::RandomOptions options;
    options.maxInstructions = 24;
    const ir::Program program = testing::randomProgram(seed, options);
    const std::string text = testing::spell(program, seed);
    for (const std::string_view name : builtinNames()) {
      // Whatever the card's API would refuse.
      Limits limits = findBuiltin("host")->fragment;
      const Limits &card = findBuiltin(name)->fragment;
      limits.native = card.native;
      limits.nativeModel = card.nativeModel;
      limits.scaleRectangles = card.scaleRectangles;
      const CheckResult result = checkFragmentProgram(text, {limits, LimitPolicy::Report});
      ASSERT_TRUE(result.ok()) << text;
      const NativeReport report = explainNative(*result.program, result.counts, limits);
      ASSERT_EQ(result.nativeCounts, report.counts) << name << "\n" << text;
      ASSERT_EQ(result.underNativeLimits, report.fits) << name << "\n" << text;
      if (report.model == NativeModel::Documented)
        continue;
      ResourceCounts sum;
      for (const Reason &reason : report.reasons) {
        sum.*reason.resource += reason.amount;
        ASSERT_TRUE(std::is_sorted(reason.instructions.begin(), reason.instructions.end()));
        for (const std::uint32_t index : reason.instructions)
          ASSERT_LT(index, result.program->code.size());
      }
      ASSERT_EQ(sum.aluInstructions, report.counts.aluInstructions) << name << "\n" << text;
      ASSERT_EQ(sum.texInstructions, report.counts.texInstructions) << name << "\n" << text;
      ASSERT_EQ(sum.parameters, report.counts.parameters) << name << "\n" << text;
      ASSERT_EQ(sum.attribs, report.counts.attribs) << name << "\n" << text;
      ASSERT_EQ(sum.temporaries, report.counts.temporaries) << name << "\n" << text;
      if (!report.nodes.empty()) {
        ASSERT_EQ(sum.texIndirections, report.counts.texIndirections) << name << "\n" << text;
        ASSERT_EQ(report.nodes.size(), report.counts.texIndirections) << name << "\n" << text;
      }
      ASSERT_EQ(report.costs.size(), result.program->code.size());
    }
  }
}

TEST(Models, TheChainNeedsNone) {
  const NativeReport report =
      explained("host", "TEX r, a, texture[0], 2D; MUL r, r, k; TEX o, r, texture[1], 2D;");
  EXPECT_EQ(report.model, NativeModel::Documented);
  EXPECT_EQ(report.chain, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(report.costs.empty());
  EXPECT_TRUE(report.cycles.bound.empty());
}

TEST(Models, AListingNamesTheLines) {
  const std::string text =
      "!!ARBfp1.0\nTEMP r;\nTEX r, fragment.texcoord[0].yxzw, texture[0], 2D;\n"
      "LRP result.color, r, fragment.color, r;\nEND";
  const CheckResult result = checked("i915", text);
  const auto listing = [&](std::string_view profile, std::string_view source) {
    return explainNative(*result.program, result.counts, findBuiltin(profile)->fragment, source)
        .disassembly;
  };
  EXPECT_EQ(listing("i915", text), "phase 1\n"
                                   "    1 alu  ; line 3: TEX, its coordinate moved\n"
                                   "phase 2\n"
                                   "    2 tex  ; line 3: TEX\n"
                                   "    3 alu  ; line 4: LRP\n"
                                   "    4 alu  ; line 4: LRP\n");
  EXPECT_EQ(listing("nv30", ""), "    1 tex  ; instruction 1: TEX\n"
                                 "    2 alu (2 passes)  ; instruction 2: LRP\n");
  EXPECT_NE(listing("r300", text).find("line 4"), std::string::npos);
  EXPECT_EQ(listing("host", text), "");
}

// Far beyond every limit, which only a policy of reporting lets through.
TEST(Models, LongProgramsAreCountedWhole) {
  std::string body = "MOV r, a;\n";
  for (int i = 0; i < 4000; ++i)
    body += i % 7 == 0 ? "TEX r, r, texture[0], 2D;\n" : "MAD r, r, k, s; SIN s, r.x;\n";
  const std::string text = whole(body + "MOV o, r;");
  for (const std::string_view name : {"r300", "nv30", "i915"}) {
    const CheckResult result = checked(name, text);
    EXPECT_FALSE(result.underNativeLimits) << name;
    EXPECT_GT(result.nativeCounts.instructions, 6000u) << name;
  }
}

TEST(Models, AreOfArbFragmentProgramsAlone) {
  const Profile &profile = *findBuiltin("nv30");
  const std::string vertex = "!!ARBvp1.0\nMOV result.position, vertex.position;\nEND";
  const CheckResult result =
      checkProgram(ir::Language::ArbVertex, vertex, {profile.vertex, LimitPolicy::Report});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.nativeCounts, result.counts);
  EXPECT_EQ(explainNative(*result.program, result.counts, profile.vertex).model,
            NativeModel::Documented);
}

} // namespace
} // namespace arbiter::fp::hw
