// Tests what programs in NVIDIA's own languages compute, before and after optimisation. The figures
// come from NVIDIA's driver (580.159) unless a test says otherwise.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "fp_compiler/front/testing/nvidia.h"
#include "fp_compiler/front/testing/test_support.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/specials.h"

namespace arbiter::fp {
namespace {

using ir::Vec4;
using testing::kInf;
using testing::kNan;
using testing_support::check;
using testing_support::expectNear;
using testing_support::generous;

/// The values of p[0..] and c[0..].
const Vec4 kGivenRows[] = {{-2, 0, 2, kNan},
                           {1, 2, 3, 4},
                           {0.5f, -0.25f, 1.75f, 0.1f},
                           {kInf, -kInf, -0.0f, 0},
                           {1e-40f, 65520, 1e10f, -1e-8f},
                           {3, 0, 1, 2.7f},
                           {0.3333333f, 2.7f, -3.6f, 100},
                           {600, -600, 520, -520}};

Vec4 rowOf(std::uint16_t index) {
  const auto value = float(index);
  return index < std::size(kGivenRows) ? kGivenRows[index]
                                       : Vec4{value, value + 0.25f, value + 0.5f, value + 0.75f};
}

CheckResult load(const std::string &text) {
  CompileOptions options = generous();
  options.limits.nvOptions = 1;
  options.limits.localParameters = 64;
  CheckResult result = check(text, options);
  EXPECT_TRUE(result.ok()) << text << result.errorString(text);
  if (result.ok()) {
    EXPECT_TRUE(ir::validate(*result.program).empty()) << text;
  }
  return result;
}

/// Runs a program. Attributes are (0.25, 0.5, 0.75, 1), and the fog coordinate is (0.625, 0, 0, 1).
ir::Evaluation run(const ir::Program &program, const NativeInterface &native) {
  ir::Inputs given;
  std::vector<Vec4> attributes;
  for (const ir::Attribute &attribute : program.attributes)
    attributes.push_back(attribute.kind == ir::AttributeKind::FogCoord
                             ? Vec4{0.625f, 0, 0, 1}
                             : Vec4{0.25f, 0.5f, 0.75f, 1});
  given.attributes = attributes;
  given.parameter = [&](const ir::Parameter &parameter) {
    if (parameter.kind == ir::ParameterKind::Local && parameter.index >= 64)
      return native.named.at(parameter.index - 64u).value;
    return rowOf(parameter.index);
  };
  return ir::evaluate(program, given);
}

Vec4 outputOf(const ir::Program &program, const ir::Evaluation &evaluation, ir::Output wanted) {
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    if (program.outputs[i] == wanted)
      return evaluation.outputs[i];
  return {9, 9, 9, 9};
}

void expectOutput(const std::string &text, ir::Output output, const Vec4 &expected) {
  CheckResult result = load(text);
  if (!result.ok())
    return;
  ir::Program &program = *result.program;
  expectNear(outputOf(program, run(program, result.native), output), expected, 2e-5f, text);
  optimise(program);
  EXPECT_TRUE(ir::validate(program).empty()) << text;
  expectNear(outputOf(program, run(program, result.native), output), expected, 2e-5f,
             text + "\noptimised:\n" + ir::print(program));
}

/// Expects the final value of R0, read as the colour.
void expectFp1(const std::string &statements, const Vec4 &expected) {
  expectOutput("!!FP1.0\n" + statements + "\nMOV o[COLR], R0;\nEND\n", {ir::OutputKind::Color, 0},
               expected);
}

/// Expects the final value of R0, read as texture coordinates.
void expectVp(const char *header, const std::string &statements, const Vec4 &expected) {
  expectOutput(std::string(header) + "\nMOV o[HPOS], v[OPOS];\n" + statements +
                   "\nMOV o[TEX0], R0;\nEND\n",
               {ir::OutputKind::TexCoord, 0}, expected);
}

constexpr const char *kVertexHeaders[] = {"!!VP1.0", "!!VP1.1", "!!VP2.0"};

TEST(NativeValues, RegistersBeginAtZero) {
  expectFp1("ADD R0.x, R0, 1;", {1, 0, 0, 0});
  expectFp1("MOV R0, H5;", {});
  for (const char *header : kVertexHeaders)
    expectVp(header, "MOV R0, R5;", {});
}

TEST(NativeValues, ResultsOfVerticesBeginAtOneInW) {
  for (const char *header : kVertexHeaders) {
    const std::string begin = std::string(header) + "\nMOV o[HPOS], v[OPOS];\n";
    expectOutput(begin + "MOV o[TEX0].x, c[1].y;\nEND\n", {ir::OutputKind::TexCoord, 0},
                 {2, 0, 0, 1});
    expectOutput(begin + "MOV o[COL1].z, c[1].y;\nEND\n", {ir::OutputKind::FrontSecondary, 0},
                 {0, 0, 2, 1});
  }
  expectOutput("!!VP2.0\nMOV o[HPOS], v[0];\nMOVC CC, c[0];\nMOV o[TEX0] (GT), c[1];\nEND\n",
               {ir::OutputKind::TexCoord, 0}, {0, 0, 3, 1});
  expectOutput("!!VP2.0\nl: MOV o[HPOS].x, c[1];\nADDC R0.x, R0.x, c[1].x;\nADDC R1.x, R0.x, "
               "-c[1].z;\nBRA l (LT.x);\nEND\n",
               {ir::OutputKind::Position, 0}, {1, 0, 0, 1});
}

TEST(NativeValues, ParametersAndConstants) {
  expectFp1("MOV R0, p[1];", {1, 2, 3, 4});
  expectFp1("MOV R0, {1,2};", {1, 2, 0, 1});
  expectFp1("MOV R0, -{1,2}.yxzw;", {-2, -1, 0, -1});
  expectFp1("MOV R0, -3;", {-3, -3, -3, -3});
  expectFp1("MOV R0, -|-3|;", {-3, -3, -3, -3});
}

TEST(NativeValues, MergedConstants) {
  expectFp1("MOV R1, p[1]; MAD R0, R1, 2, -1;", {1, 3, 5, 7});
  expectFp1("DEFINE two = 2; DEFINE v = {3, -1, two}; MOV R1, p[1]; MAD R0, R1, two, v.y;",
            {1, 3, 5, 7});
  expectFp1("DECLARE blue = {1,2}; MOV R0, blue;", {1, 2, 0, 1});
  expectFp1("DECLARE blue = 3; MOV R0, blue.wzyx;", {3, 3, 3, 3});
  expectFp1("DECLARE blue; MOV R0, blue;", {});
}

TEST(NativeValues, FogCoordinatesOfFragments) {
  // The values follow the specification. NVIDIA gives the coordinate in every component.
  expectFp1("MOV R0, f[FOGC];", {0.625f, 0, 0, 0});
  expectFp1("MOV R0, -|f[FOGC].wxxw|;", {0, -0.625f, -0.625f, 0});
  expectFp1("RCP R0, f[FOGC].x;", {1.6f, 1.6f, 1.6f, 1.6f});
}

TEST(NativeValues, ConditionsOfFragments) {
  expectFp1("MOVC RC, p[0]; MOV R0 (LT), 1; MOV R0 (NE.w), 2;", {2, 2, 2, 2});
  expectFp1("ADDC HC.x, R0, -1; MOV R0 (LT.x), 1;", {1, 1, 1, 1});
  expectFp1("MOVC_SAT RC, p[0]; MOV R0 (EQ), 1;", {1, 1, 0, 1});
}

TEST(NativeValues, RootsOfFragmentsAndOfSecondVertices) {
  const auto four = [](const std::string &row) {
    return "RSQ R0.x, " + row + ".x; RSQ R0.y, " + row + ".y; RSQ R0.z, " + row + ".z; RSQ R0.w, " +
           row + ".w;";
  };
  const float root = 0.70710678f;
  expectFp1(four("p[0]"), {kNan, kInf, root, kNan});
  expectFp1(four("p[3]"), {0, kNan, -kInf, kInf});
  expectFp1("RSQ R0, |p[0].x|;", {root, root, root, root});
  expectFp1("RSQ R0, -|p[0].x|;", {kNan, kNan, kNan, kNan});
  expectVp("!!VP2.0", four("c[0]"), {kNan, kInf, root, kNan});
  expectVp("!!VP2.0", four("c[3]"), {0, kNan, -kInf, kInf});
  expectVp("!!VP1.1", four("c[0]"), {root, kInf, root, kNan});
  expectVp("!!VP1.1", four("c[3]"), {0, 0, kInf, kInf});
}

TEST(NativeValues, ARootOfASquareNeedsNoSign) {
  const std::string square = "!!FP1.0\nDP3 R0.x, R1, R1;\nRSQ o[COLR], R0.x;\nEND\n";
  const std::string sum = "!!FP1.0\nDP3 R0.x, R1, R2;\nRSQ o[COLR], R0.x;\nEND\n";
  const std::string hidden = "!!VP2.0\nDP3 R0.x, R1, R1;\nl: RSQ o[HPOS], R0.x;\nADDC R0.x, R0.x, "
                             "-c[1].x;\nBRA l (GT.x);\nEND\n";
  const auto logarithms = [](const std::string &text) {
    const CheckResult result = load(text);
    return std::count_if(result.program->code.begin(), result.program->code.end(),
                         [](const ir::Instruction &i) { return i.op == ir::Opcode::Lg2; });
  };
  EXPECT_EQ(logarithms(square), 0);
  EXPECT_EQ(logarithms(sum), 1);
  EXPECT_EQ(logarithms(hidden), 1);
  expectFp1("DP3 R1.x, p[1], p[1]; MOV R1.x, p[0].x; RSQ R0, R1.x;", {kNan, kNan, kNan, kNan});
  expectFp1("MOV R2, p[1]; DP3 R1.x, R2, -R2; RSQ R0, R1.x;", {kNan, kNan, kNan, kNan});
  expectFp1("MOV R2, p[0]; MUL R1, R2, R2; RSQ R0, R1.x;", {0.5f, 0.5f, 0.5f, 0.5f});
}

TEST(NativeValues, PowersOfFragments) {
  expectFp1("MOV R1, p[3]; MOV R2, p[0]; POW R0.x, R1.w, R1.w; POW R0.y, R1.w, 1; "
            "POW R0.z, R1.w, -1; POW R0.w, R2.x, 2;",
            {kNan, 0, kInf, kNan});
  expectFp1("POW R0, p[1].y, p[1].y;", {4, 4, 4, 4});
  expectFp1("MOV R1.x, 1; LIT R0, R1;", {1, 1, 1, 1});
}

TEST(NativeValues, ReciprocalsWithinBounds) {
  for (const char *header : {"!!VP1.1", "!!VP2.0"})
    expectVp(header, "RCC R0.x, c[3].x; RCC R0.y, c[3].y; RCC R0.z, c[3].z; RCC R0.w, c[3].w;",
             {0x1p-64f, -0x1p-64f, -0x1p64f, 0x1p64f});
}

TEST(NativeValues, AddressesOfVertices) {
  for (const char *header : kVertexHeaders) {
    expectVp(header, "ARL A0.x, c[6].z; MOV R0, c[A0.x+30];", {26, 26.25f, 26.5f, 26.75f});
    expectVp(header, "ARL A0.x, c[6].z; MOV R0, -c[A0.x+30].wzyx;",
             {-26.75f, -26.5f, -26.25f, -26});
    expectVp(header, "ARL A0.x, c[7].y; MOV R0, c[A0.x];", {});
  }
  expectVp("!!VP1.0", "ARL A0.x, c[6].w; MOV R0, c[A0.x-4];", {}); // 96 is no row
  expectVp("!!VP2.0", "ARL A0.x, c[6].w; MOV R0, c[A0.x-4];", {96, 96.25f, 96.5f, 96.75f});
  expectVp("!!VP2.0", "ARR A0, c[2].zxyz; MOV R1, c[A0.y+22]; ADD R0, c[A0.x+20], -R1;", {});
  // Each address is clamped to -512..511, and so is the sum: 511 + 511 is 511.
  expectVp("!!VP2.0", "ARL A0, c[7].xzxz; MOV R0, c[A0.x-256];", {255, 255.25f, 255.5f, 255.75f});
  expectVp("!!VP2.0", "ARL A0, c[7].xzxz; ARA A1, A0; MOV R0, c[A1.x-256];",
           {255, 255.25f, 255.5f, 255.75f});
}

TEST(NativeValues, BranchesAndSubroutines) {
  expectVp("!!VP2.0",
           "MOVC R1.x, c[5].x; top: ADD R0, R0, c[1]; ADDC R1.x, R1.x, -c[1].x; "
           "BRA top (GT.x);",
           {3, 6, 9, 12});
  expectOutput("!!VP2.0\nMOV o[HPOS], v[OPOS];\nCAL s;\nCAL s;\nMOV o[TEX0], R0;\nRET;\ns: ADD R0, "
               "R0, c[1];\nRET;\nEND\n",
               {ir::OutputKind::TexCoord, 0}, {2, 4, 6, 8});
  expectOutput("!!VP2.0\nMOV R0, c[1];\nmain: MOV o[HPOS], R0;\nEND\n",
               {ir::OutputKind::Position, 0}, {});
}

TEST(NativeValues, StateProgramsReadWhatTheyWrite) {
  const auto row = [](std::uint8_t index) {
    return ir::Output{ir::OutputKind::EnvParameter, index};
  };
  const std::string text = "!!VSP1.0\nMOV c[20].x, v[0];\nADD c[21], c[20], c[20];\nMUL R0, c[21], "
                           "c[21];\nMOV c[20].y, R0;\nMOV c[22], c[20];\nEND\n";
  expectOutput(text, row(20), {0.25f, 1640.25f, 20.5f, 20.75f});
  expectOutput(text, row(21), {0.5f, 40.5f, 41, 41.5f});
  expectOutput(text, row(22), {0.25f, 1640.25f, 20.5f, 20.75f});
  const std::string relative = "!!VSP1.0\nARL A0.x, c[1].z;\nMOV c[20], -c[4].yyyy;\nMOV c[21], "
                               "c[A0.x+17];\nMOV c[22], -c[A0.x+18].wxyz;\nMOV c[21].y, "
                               "c[A0.x+19];\nEND\n";
  expectOutput(relative, row(21), {-65520, 65520, -65520, -65520});
  expectOutput(relative, row(22), {65520, 65520, 65520, 65520});
}

} // namespace
} // namespace arbiter::fp
