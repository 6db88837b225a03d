#include <algorithm>
#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <numeric>
#include <sstream>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/r300/check/legality.h"
#include "fp_compiler/hw/r300/compile.h"
#include "fp_compiler/hw/r300/report/disassemble.h"

/// Compares the compiler with programs composed by hand, and with another compiler's results.
namespace arbiter::r300 {
namespace {

using fp::hw::r300::Code;

Code compiled(const std::string &text) {
  fp::CompileOptions options;
  options.limits.api = {4096, 4096, 4096, 4096, 256, 256, 32, 0};
  options.limits.localParameters = options.limits.envParameters = 64;
  options.limits.textureCoords = options.limits.textureUnits = 8;
  options.limits.textureImageUnits = 16;
  const fp::CheckResult checked = fp::checkFragmentProgram(text, options);
  EXPECT_TRUE(checked.ok()) << checked.errorString(text) << text;
  return checked.ok() ? fp::hw::r300::compile(*checked.program, {}) : Code();
}

std::string read(const std::string &path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_FALSE(text.str().empty()) << path;
  return text.str();
}

/// The best result that a person found with the machine's tables: one operation in each half of a
/// pair, with both halves used whenever possible, and presubtract, modifiers, clamps and copies at
/// no cost. `why` explains it; a chain is the longest path of dependent operations.
struct Best {
  const char *program;
  std::uint32_t pairs, textures, nodes;
  const char *why;
};

constexpr Best kBest[] = {
    {"demos/programs/brightness_contrast.fp", 7, 1, 1,
     "alpha: 3 LG2, 3 EX2, the MAD of w; the MULs and MADs of xyz beside them"},
    {"demos/programs/cartoon.fp", 8, 2, 2,
     "RGB: 4 DP3, 2 MUL, 1 MAD, the RSQs beside them; then 1 MUL"},
    {"demos/programs/life_naive.fp", 21, 9, 2,
     "11 ADDs of places with one register that holds wzyw of step; count: 4 pairs, two ADDs in "
     "each "
     "by presubtract; rule: SUB MAD CMP MUL MAX MAX"},
    {"demos/programs/life_pack.fp", 2, 3, 1,
     "red and green by one CMP of a constant's signs, blue; alpha beside them"},
    {"demos/programs/life_packed.fp", 5, 4, 2,
     "both ADDs by presubtract, DP3, MOV, MAD; then the copy of the sample"},
    {"demos/programs/lighting.fp", 17, 2, 1,
     "chain: SUB DP3 RSQ MUL ADD DP3 RSQ MUL DP3, LIT's MAX LG2 MUL EX2 CMP, MUL MUL MAD"},
    {"demos/programs/pass_through.fp", 1, 1, 1, "the copy of the sample"},
    {"demos/programs/twirl.fp", 3, 2, 2, "MAD, ADD; then the copy of the sample"},
    {"tests/r300_vs_interpreter/classics/lit.fp", 12, 1, 1,
     "RGB: 5 DP3, 3 MUL, MAX, MUL, MAD; LIT's chain waits one pair for CMP"},
    {"tests/r300_vs_interpreter/classics/gloss.fp", 2, 2, 1, "MUL, MAD; the copy of w beside them"},
    {"tests/r300_vs_interpreter/classics/water.fp", 3, 3, 2,
     "ADD, MAD: four addresses, so that presubtract does not make them one; then MUL"},
    {"tests/r300_vs_interpreter/classics/dot3.fp", 3, 2, 1,
     "the light's MAD, DP3 with the normal's by presubtract (1-2s), MUL"},
    {"tests/r300_vs_interpreter/classics/reflect.fp", 6, 2, 2,
     "3 DP3 with the normal's MAD by presubtract, DP3 doubled by its modifier, MAD; then MUL"},
    {"tests/r300_vs_interpreter/classics/blur.fp", 17, 9, 2,
     "8 ADDs of places; MUL and 8 MADs of colours"},
    {"tests/r300_vs_interpreter/classics/fog.fp", 3, 1, 1,
     "MUL; the factor's MAD, whose two addresses leave MUL of rgb no room; the blend by "
     "presubtract"},
    {"tests/r300_vs_interpreter/classics/sepia.fp", 3, 1, 1, "DP3, MUL, LRP by presubtract"},
    {"tests/r300_vs_interpreter/classics/cutout.fp", 2, 2, 2, "SUB; KIL, MUL"},
    {"tests/r300_vs_interpreter/classics/spot.fp", 3, 2, 1,
     "DP3, RCP beside the MUL of the samples, MUL"},
    {"tests/r300_vs_interpreter/classics/splat.fp", 3, 4, 1, "2 LRP by presubtract, MUL"},
    {"tests/r300_vs_interpreter/classics/parallax.fp", 4, 3, 2, "2 MAD; then DP3, MUL"},
    {"tests/r300_vs_interpreter/classics/ripple.fp", 13, 1, 2,
     "SUB, DP3, RSQ, RCP, MAD; SIN's MAD, FRC, a parabola and the two MADs that mend it; MUL, MAD; "
     "then the copy of the sample"},
};

TEST(BestKnown, TheMedianIsNearWhatAPersonComposed) {
  std::vector<double> ratios;
  std::printf("%-40s %14s %14s %14s\n", "program", "pairs (best)", "TEX (best)", "nodes (best)");
  for (const Best &best : kBest) {
    const Code code = compiled(read(std::string(ARBITER_SOURCE_ROOT "/") + best.program));
    EXPECT_TRUE(fp::hw::r300::faults(code).empty()) << best.program;
    const double ratio = double(code.pairs.size()) / best.pairs;
    ratios.push_back(ratio);
    std::printf("%-40s %8zu (%3u) %8zu (%3u) %8zu (%3u)   %.2f  %s\n", best.program,
                code.pairs.size(), best.pairs, code.textures.size(), best.textures,
                code.nodes.size(), best.nodes, ratio, best.why);
    EXPECT_EQ(code.textures.size(), best.textures) << best.program;
    EXPECT_EQ(code.nodes.size(), best.nodes) << best.program;
  }
  std::sort(ratios.begin(), ratios.end());
  const double median = ratios[ratios.size() / 2];
  const double mean = std::accumulate(ratios.begin(), ratios.end(), 0.0) / double(ratios.size());
  std::printf("median %.2f, mean %.2f, worst %.2f\n", median, mean, ratios.back());
  EXPECT_LE(median, 1.15);
}

/// Slots of single statements, written directly to the output, by the compiler of Mesa 22.3.6's
/// r300 driver, which was built separately and run. LRP, SGE and SLT use presubtract.
struct Figure {
  const char *statement;
  std::uint32_t slots;
};

constexpr Figure kMesa[] = {
    {"MOV result.color, a;", 1},
    {"ADD result.color, a, b;", 1},
    {"SUB result.color, a, b;", 1},
    {"MUL result.color, a, b;", 1},
    {"MAD result.color, a, b, c;", 1},
    {"MIN result.color, a, b;", 1},
    {"MAX result.color, a, b;", 1},
    {"ABS result.color, a;", 1},
    {"FRC result.color, a;", 1},
    {"CMP result.color, a, b, c;", 1},
    {"DP3 result.color, a, b;", 1},
    {"DP4 result.color, a, b;", 1},
    {"DPH result.color, a, b;", 1},
    {"RCP result.color, a.x;", 1},
    {"RSQ result.color, a.x;", 1},
    {"EX2 result.color, a.x;", 1},
    {"LG2 result.color, a.x;", 1},
    {"SGE result.color, a, b;", 1},
    {"SLT result.color, a, b;", 1},
    {"LRP result.color, a, b, c;", 1},
    {"FLR result.color, a;", 2},
    {"XPD result.color.xyz, a, b;", 2},
    {"POW result.color, a.x, b.x;", 3},
    {"DST result.color, a, b;", 5},
    {"SIN result.color, a.x;", 7},
    {"COS result.color, a.x;", 7},
    {"LIT result.color, a;", 9},
    {"SCS result.color.xy, a.x;", 12},
    // The unit lacks these swizzles and signs, so that the count includes copies and the operation
    // itself.
    {"ADD result.color, a.xzyw, b;", 3},
    {"ADD result.color, a.yxzw, b;", 4},
    {"ADD result.color, a.zyxw, b;", 4},
    {"SWZ result.color, a, -x, y, z, w;", 3},
};

TEST(BestKnown, NoStatementTakesMoreThanAnotherCompilersCode) {
  for (const Figure &figure : kMesa) {
    const std::string text = std::string("!!ARBfp1.0\nATTRIB a = fragment.texcoord[0];\n"
                                         "ATTRIB b = fragment.texcoord[1];\n"
                                         "ATTRIB c = fragment.texcoord[2];\n") +
                             figure.statement + "\nEND\n";
    const Code code = compiled(text);
    std::printf("%-36s %2zu pairs, Mesa %2u\n", figure.statement, code.pairs.size(), figure.slots);
    EXPECT_LE(code.pairs.size(), figure.slots) << figure.statement;
  }
}

} // namespace
} // namespace arbiter::r300
