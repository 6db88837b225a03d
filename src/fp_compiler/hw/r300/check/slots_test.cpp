#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/hw/r300/check/legality.h"
#include "fp_compiler/hw/r300/compile.h"
#include "fp_compiler/hw/r300/report/disassemble.h"

/// Tests how many slots, nodes and constants programs use on the chip. The peer figures come from
/// Mesa 22.3.6's r300 compiler, built alone and run on such statements. They are kUnknown if it was
/// not run.
namespace arbiter::fp::hw::r300 {
namespace {

constexpr int kUnknown = 1000;

struct Row {
  const char *name;
  const char *text; ///< goes between END and the header with its declarations
  int peerPairs;
  int pairs;
  int peerNodes;
  int nodes;
  int constants; ///< 0, 1/2 and 1 cost none where a select gives them
};

constexpr const char *kHeader = "!!ARBfp1.0\n"
                                "ATTRIB v0 = fragment.texcoord[0];\n"
                                "ATTRIB v1 = fragment.texcoord[1];\n"
                                "ATTRIB v2 = fragment.texcoord[2];\n"
                                "PARAM p = program.local[0];\n"
                                "OUTPUT o = result.color;\n"
                                "TEMP r, s, t, u;\n";

const Row kRows[] = {
    // Opcodes of one slot.
    {"MOV", "MOV o, v0;", 1, 1, 1, 1, 0},
    {"ADD", "ADD o, v0, v1;", 1, 1, 1, 1, 0},
    {"SUB", "SUB o, v0, v1;", 1, 1, 1, 1, 0},
    {"MUL", "MUL o, v0, v1;", 1, 1, 1, 1, 0},
    {"MAD", "MAD o, v0, v1, v2;", 1, 1, 1, 1, 0},
    {"MIN", "MIN o, v0, v1;", 1, 1, 1, 1, 0},
    {"MAX", "MAX o, v0, v1;", 1, 1, 1, 1, 0},
    {"ABS", "ABS o, v0;", 1, 1, 1, 1, 0},
    {"FRC", "FRC o, v0;", 1, 1, 1, 1, 0},
    {"CMP", "CMP o, v0, v1, v2;", 1, 1, 1, 1, 0},
    {"DP3", "DP3 o, v0, v1;", 1, 1, 1, 1, 0},
    {"DP4", "DP4 o, v0, v1;", 1, 1, 1, 1, 0},
    {"DPH", "DPH o, v0, v1;", 1, 1, 1, 1, 0},
    {"RCP", "RCP o, v0.x;", 1, 1, 1, 1, 0},
    {"RSQ", "RSQ o, v0.x;", 1, 1, 1, 1, 0},
    {"EX2", "EX2 o, v0.x;", 1, 1, 1, 1, 0},
    {"LG2", "LG2 o, v0.x;", 1, 1, 1, 1, 0},
    {"SGE", "SGE o, v0, v1;", 1, 1, 1, 1, 0},
    {"SLT", "SLT o, v0, v1;", 1, 1, 1, 1, 0},
    {"SAT", "MAD_SAT o, v0, v1, v2;", 1, 1, 1, 1, 0},
    {"negated", "MAD o, -v0, v1, -v2;", kUnknown, 1, kUnknown, 1, 0},
    // Opcodes of two or more slots.
    {"SGE of a swizzle", "SGE o, v0, v1.yzxw;", kUnknown, 2, kUnknown, 1, 0},
    {"SLT of a magnitude", "ABS r, v0; SLT o, r, v1;", kUnknown, 2, kUnknown, 1, 0},
    {"FLR", "FLR o, v0;", 2, 2, 1, 1, 0},
    {"XPD", "XPD o, v0, v1;", 2, 2, 1, 1, 0},
    {"LRP", "LRP o, v0, v1, v2;", 2, 1, 1, 1, 0},
    {"LRP of a swizzle", "LRP o, v0, v1, v2.yzxw;", kUnknown, 2, kUnknown, 1, 0},
    {"POW", "POW o, v0.x, v1.x;", 3, 3, 1, 1, 0},
    {"normalize", "DP3 r.x, v0, v0; RSQ r.x, r.x; MUL o, v0, r.x;", 3, 3, 1, 1, 0},
    {"DST", "DST o, v0, v1;", 5, 3, 1, 1, 0},
    {"SIN", "SIN o, v0.x;", 7, 5, 1, 1, 1},
    {"COS", "COS o, v0.x;", 7, 5, 1, 1, 1},
    {"LIT", "LIT o, v0;", 9, 5, 1, 1, 1},
    {"SCS", "SCS o.xy, v0.x;", 12, 5, 1, 1, 1},
    // A scalar in w leaves the RGB half free for another operation.
    {"RCP beside MUL", "MUL o.xyz, v0, v1; RCP o.w, v2.x;", kUnknown, 1, kUnknown, 1, 0},
    {"RCP in x takes both", "MUL r.xyz, v0, v1; MOV o.yzw, r; RCP o.x, v2.x;", kUnknown, 2,
     kUnknown, 1, 0},
    {"DP3 beside RSQ", "DP3 o.xyz, v0, v1; RSQ o.w, v2.w;", kUnknown, 1, kUnknown, 1, 0},
    // Swizzles.
    {".xyz", "MOV o.xyz, v0;", 1, 1, 1, 1, 0},
    {".xxxx", "MOV o, v0.x;", 1, 1, 1, 1, 0},
    {".yyyy", "MOV o, v0.y;", 1, 1, 1, 1, 0},
    {".zzzz", "MOV o, v0.z;", 1, 1, 1, 1, 0},
    {".wwww", "MOV o, v0.w;", 1, 1, 1, 1, 0},
    {".yzxw", "MOV o, v0.yzxw;", 1, 1, 1, 1, 0},
    {".zxyw", "MOV o, v0.zxyw;", 1, 1, 1, 1, 0},
    {".wzyx", "MOV o, v0.wzyx;", 1, 1, 1, 1, 0},
    {".xzyw", "ADD o, v0.xzyw, v1;", 3, 2, 1, 1, 0},
    {".xyxw", "ADD o, v0.xyxw, v1;", 3, 2, 1, 1, 0},
    {".xyww", "ADD o, v0.xyww, v1;", 3, 2, 1, 1, 0},
    {".wwzx", "ADD o, v0.wwzx, v1;", 3, 2, 1, 1, 0},
    {".yxzw", "ADD o, v0.yxzw, v1;", 4, 3, 1, 1, 0},
    {".zyxw", "ADD o, v0.zyxw, v1;", 4, 3, 1, 1, 0},
    {"only the components used", "ADD o.yz, v0.xzyw, v1;", 1, 1, 1, 1, 0},
    {"SWZ -x,y,z,w", "SWZ o, v0, -x, y, z, w;", 3, 2, 1, 1, 0},
    {"SWZ x,y,0,1", "SWZ o, v0, x, y, 0, 1;", 3, 2, 1, 1, 0},
    {"signs that one reads", "SWZ r, v0, -x, y, z, w; ADD o, r, v1;", kUnknown, 2, kUnknown, 1, 0},
    {"DP3 of one permutation", "DP3 o, v0.yxzw, v1.yxzw;", kUnknown, 1, 1, 1, 0},
    {"DP3 of a swizzle", "DP3 o, v0.yxzw, v1;", kUnknown, 3, kUnknown, 1, 0},
    {"signs on both sides of DP3", "SWZ r, v0, -x, y, z, w; SWZ s, v1, -x, y, z, w; DP3 o, r, s;",
     kUnknown, 1, 1, 1, 0},
    // Copies and numbers.
    {"a copy", "MOV r, v0; ADD o, r, v1;", kUnknown, 1, kUnknown, 1, 0},
    {"0, 1/2 and 1", "MAD o, v0, 0.5, 1.0;", kUnknown, 1, kUnknown, 1, 0},
    {"a power of two", "MUL o, v0, 4.0;", kUnknown, 1, kUnknown, 1, 0},
    {"any other number", "MUL o, v0, 3.0;", kUnknown, 1, kUnknown, 1, 1},
    {"one number twice", "MUL r, v0, 3.0; MAX o, r, {3.0, 3.0, 3.0, 3.0};", kUnknown, 2, kUnknown,
     1, 1},
    {"SLT of 1/2", "SLT o.xyz, v0, 0.5;", kUnknown, 1, kUnknown, 1, 1},
    // An operation with a single reader is merged into that reader.
    {"a product in a sum", "MUL r, v0, v1; ADD o, r, v2;", kUnknown, 1, kUnknown, 1, 0},
    {"a product in a difference", "MUL r, v0, v1; SUB o, v2, r;", kUnknown, 1, kUnknown, 1, 0},
    {"a sum in a product", "ADD r, v0, v1; MUL o, r, v2;", kUnknown, 1, kUnknown, 1, 0},
    {"1-x", "SUB r, 1.0, v0; MUL o, r, v1;", kUnknown, 1, kUnknown, 1, 0},
    {"a sum in a DP3", "SUB r, v0, v1; DP3 o, r, v2;", kUnknown, 1, kUnknown, 1, 0},
    {"a copy that clamps", "MUL r, v0, v1; MOV_SAT o, r;", kUnknown, 1, kUnknown, 1, 0},
    {"a sum that two read", "ADD r, v0, v1; MUL s, r, v2; MAX o, r, s;", kUnknown, 3, kUnknown, 1,
     0},
    // Results.
    {"depth", "MOV o, v0; MOV result.depth.z, v1.z;", kUnknown, 2, kUnknown, 1, 0},
    {"depth beside RGB", "MOV o.xyz, v0; MOV result.depth.z, v1.z;", kUnknown, 1, kUnknown, 1, 0},
    {"a result that is read", "MUL r, v0, v1; MOV o, r; MUL s, r, v2; MOV result.depth.z, s.z;",
     kUnknown, 3, kUnknown, 1, 0},
    {"fragment.position", "MOV o, fragment.position;", kUnknown, 3, kUnknown, 1, 2},
    // Texture operands.
    {"TEX", "TEX r, v0, texture[0], 2D; MUL o, r, v1;", 1, 1, 1, 1, 0},
    {"TEX to a result", "TEX o, v0, texture[0], 2D;", 1, 1, 1, 1, 0},
    {"TEX_SAT", "TEX_SAT o, v0, texture[0], 2D;", 1, 1, 1, 1, 0},
    {"TEX under a mask", "TEX r.xy, v0, texture[0], 2D; MUL o, r.xyyy, v1;", kUnknown, 2, kUnknown,
     1, 0},
    {"TEX of a constant", "TEX o, p, texture[0], 2D;", 2, 2, 2, 2, 1},
    {"TEX of .yxzw", "TEX o, v0.yxzw, texture[0], 2D;", 4, 3, 2, 2, 0},
    {"TEX of a negated", "TEX o, -v0, texture[0], 2D;", 2, 2, 2, 2, 0},
    {"TEX of unused swizzles", "TEX o, v0.xyxy, texture[0], 2D;", kUnknown, 1, kUnknown, 1, 0},
    {"TEX of a TEX", "TEX r, v0, texture[0], 2D; TEX o, r, texture[1], 2D;", kUnknown, 2, kUnknown,
     2, 0},
    {"independent chains are one node",
     "TEX r, v0, texture[0], 2D; MOV s, r; MOV t, v1; TEX r, t, texture[1], 2D;"
     "MUL s, s, r; MOV t, v2; TEX r, t, texture[2], 2D; MUL o, s, r;",
     kUnknown, 2, kUnknown, 1, 0},
    {"KIL", "KIL v0; MOV o, v1;", kUnknown, 1, kUnknown, 1, 0},
    {"KIL of a swizzle", "KIL v0.x; MOV o, v1;", 2, 2, 2, 2, 0},
    {"KIL of a scalar", "SUB r.x, v0.w, v1.w; KIL r.x; MOV o, v1;", kUnknown, 2, kUnknown, 2, 0},
    {"KIL of a dot product", "DP3 r.w, v0, v2; KIL r.w; MOV o, v1;", kUnknown, 2, kUnknown, 2, 0},
    {"a table by a scalar", "MUL r.w, v0.x, v1.y; TEX o, r.w, texture[0], 1D;", kUnknown, 2,
     kUnknown, 2, 0},
    {"a table by a reciprocal", "RCP r.w, v0.x; TEX o, r.w, texture[0], 1D;", kUnknown, 2, kUnknown,
     2, 0},
    {"KIL of a negated", "KIL -v0; MOV o, v1;", kUnknown, 2, kUnknown, 2, 0},
};

Code compiled(const std::string &text, bool scaleRectangles = false) {
  fp::CompileOptions options;
  options.limits = findBuiltin("r300")->fragment;
  options.policy = LimitPolicy::Report;
  const CheckResult checked = checkFragmentProgram(text, options);
  EXPECT_TRUE(checked.program) << checked.errorString(text);
  if (!checked.program)
    return {};
  Code code = compile(*checked.program, {scaleRectangles});
  for (const Fault &fault : faults(code, *checked.program))
    ADD_FAILURE() << fault.text;
  return code;
}

// gtest prints the parameter when a test fails.
void PrintTo(const Row &row, std::ostream *stream) { *stream << row.name; }

class Slots : public ::testing::TestWithParam<Row> {};

TEST_P(Slots, AsInTheTable) {
  const Row &row = GetParam();
  const std::string text = std::string(kHeader) + row.text + "\nEND\n";
  const Code code = compiled(text);
  EXPECT_EQ(int(code.pairs.size()), row.pairs) << text;
  EXPECT_EQ(int(code.nodes.size()), row.nodes) << text;
  EXPECT_EQ(int(code.constants.size()), row.constants) << text;
  EXPECT_LE(int(code.pairs.size()), row.peerPairs) << text;
  EXPECT_LE(int(code.nodes.size()), row.peerNodes) << text;
}

std::string nameOf(const ::testing::TestParamInfo<Row> &row) {
  std::string name = std::to_string(row.index) + "_";
  for (const char *c = row.param.name; *c; ++c)
    name += std::isalnum(static_cast<unsigned char>(*c)) ? *c : '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(Table, Slots, ::testing::ValuesIn(kRows), nameOf);

} // namespace
} // namespace arbiter::fp::hw::r300
