#include "fp_compiler/hw/native.h"

#include <algorithm>

#include "fp_compiler/hw/dataflow.h"
#include "fp_compiler/hw/native_support.h"
#include "fp_compiler/testing/random.h"

namespace arbiter::fp::hw {
namespace {

using namespace testing;

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

// A shared slot counts as half a slot for each of its operations. The reasons still add up to whole
// numbers.
TEST(R300, PartsOfSharedSlots) {
  const NativeReport report = explained("r300", "MUL r.xyz, a, k;\nRCP r.w, b.x;\nMOV o, r;");
  EXPECT_EQ(report.costs[1].slots, 0.5);
  const Reason *single = find(report, "instructions of one slot");
  ASSERT_NE(single, nullptr) << all(report);
  EXPECT_EQ(single->amount, report.counts.aluInstructions) << all(report);
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

// The reasons of each count add up to it, and countNative() agrees with explainNative().
TEST(Models, CountsAreThoseOfTheReportOnRandomPrograms) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    fp::testing::RandomOptions options;
    options.maxInstructions = 24;
    const ir::Program program = fp::testing::randomProgram(seed, options);
    const std::string text = fp::testing::spell(program, seed);
    for (const std::string_view name : builtinNames()) {
      // The program may exceed what the card's API accepts.
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

// The program is far beyond every limit. Only LimitPolicy::Report lets it through.
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
