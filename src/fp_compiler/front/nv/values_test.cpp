// Tests what programs under NVIDIA's options compute, before and after optimisation. The figures
// come from NVIDIA's driver (580.159).
#include <bit>
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
using testing_support::kF1;
using testing_support::kF2;
using testing_support::kV2;
using testing_support::kV3;

/// The values of program.local[0..].
const Vec4 kLocals[] = {{-2, 0, 2, kNan},
                        {1, 2, 3, 4},
                        {0.5f, -0.25f, 1.75f, 0.1f},
                        {kInf, -kInf, -0.0f, 0},
                        {1e-40f, 65520, 1e10f, -1e-8f},
                        {3, 0, 1, 2.7f}};

ir::Program load(std::string_view option, const std::string &statements) {
  const bool vertex = option.find("vertex") != std::string_view::npos;
  CompileOptions options = generous();
  options.limits.nvOptions = 2;
  std::string text = std::string(vertex ? "!!ARBvp1.0\n" : "!!ARBfp1.0\n") + "OPTION " +
                     std::string(option) + ";\nTEMP r, s, t;\n";
  for (std::size_t i = 0; i < std::size(kLocals); ++i)
    text += "PARAM p" + std::to_string(i) + " = program.local[" + std::to_string(i) + "];\n";
  text += statements + "\nEND\n";
  CheckResult result = check(text, options);
  EXPECT_TRUE(result.ok()) << result.errorString(text);
  if (!result.ok())
    return {};
  EXPECT_TRUE(ir::validate(*result.program).empty()) << text;
  return std::move(*result.program);
}

ir::Inputs inputs() {
  ir::Inputs given;
  given.parameter = [](const ir::Parameter &parameter) {
    return parameter.kind == ir::ParameterKind::Local ? kLocals[parameter.index] : Vec4{};
  };
  given.texture = [](const ir::Sample &sample) {
    const float level = sample.lod        ? *sample.lod
                        : sample.gradient ? sample.gradient->x[0] + 10 * sample.gradient->y[1]
                                          : -1.0f;
    return Vec4{sample.coordinate[0], sample.coordinate[1], level, sample.bias};
  };
  return given;
}

Vec4 outputOf(const ir::Program &program, const ir::Evaluation &evaluation) {
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    if (program.outputs[i].kind == ir::OutputKind::Color ||
        program.outputs[i] == ir::Output{ir::OutputKind::TexCoord, 0})
      return evaluation.outputs[i];
  return {};
}

/// Expects the final value of r, read as the colour, or as texcoord[0] of a vertex program.
void expectValue(std::string_view option, const std::string &statements, const Vec4 &expected) {
  const bool vertex = option.find("vertex") != std::string_view::npos;
  const bool open = statements.find("RET") != std::string::npos;
  const std::string result = vertex ? "result.texcoord[0]" : "result.color";
  ir::Program program = load(option, open ? statements : statements + "\nMOV " + result + ", r;");
  expectNear(outputOf(program, ir::evaluate(program, inputs())), expected, 2e-6f, statements);
  optimise(program);
  EXPECT_TRUE(ir::validate(program).empty()) << statements;
  expectNear(outputOf(program, ir::evaluate(program, inputs())), expected, 2e-6f,
             statements + "\noptimised:\n" + ir::print(program));
}

TEST(NvValues, EveryConditionOfNumbersAndNan) {
  const std::pair<const char *, Vec4> kRows[] = {
      {"EQ", {0, 1, 0, 0}}, {"NE", {1, 0, 1, 1}}, {"LT", {1, 0, 0, 0}}, {"LE", {1, 1, 0, 0}},
      {"GT", {0, 0, 1, 0}}, {"GE", {0, 1, 1, 0}}, {"TR", {1, 1, 1, 1}}, {"FL", {0, 0, 0, 0}}};
  for (const auto &[rule, passes] : kRows) {
    for (const std::string_view option : {kF1, kF2, kV2, kV3})
      expectValue(option, std::string("MOVC s, p0; MOV r, 0.0; MOV r (") + rule + "), 1.0;",
                  passes);
    expectValue(kF2, std::string("MOVC s, p0; IF TR; MOV r (") + rule + "), 1.0; ENDIF;", passes);
  }
}

TEST(NvValues, ConditionCodesAreSetAndTested) {
  expectValue(kF1, "MOV r (EQ), 1.0;", {1, 1, 1, 1}); // as they start
  expectValue(kF1, "MOVC s, p0; MOV r, 0.0; MOV r (NE.yxzw), 1.0;", {0, 1, 1, 1});
  // The code is set from the value after _SAT, under both masks.
  expectValue(kF1, "MOVC_SAT s, p0; MOV r, 0.0; MOV r (GT), 1.0;", {0, 0, 1, 0});
  expectValue(kF1, "MOVC s.y, 1.0; MOV r, 0.0; MOV r (GT), 1.0;", {0, 1, 0, 0});
  expectValue(kF1, "MOVC s, p0; MOVC s (EQ), 3.0; MOV r, 0.0; MOV r (GT), 1.0;", {0, 1, 1, 0});
  expectValue(kF1, "MOVC s, p4; MOV r, 0.0; MOV r (EQ), 1.0;", {1, 0, 0, 0}); // a denormal
  // The specification's example.
  expectValue(kF1, "MOVC s, p0; MOVC s.xyz, p0.yzwx; MOV s, 1.0; MOV r, s; MOVC r (NE), p0.zywx;",
              {1, 0, kNan, -2});
  expectValue(kV3, "MOVC1 s, p0; MOVC0 s, p1; MOV r, 0.0; MOV r (LT1), 1.0;", {1, 0, 0, 0});
  expectValue(kV3, "MOVC s, p0; MOV r, 0.0; MOV r (LT0), 1.0;", {1, 0, 0, 0});
}

TEST(NvValues, SetOnAndSign) {
  expectValue(kF1, "SEQ r, p0, {-2, 1, 3, 0};", {1, 0, 0, 0});
  expectValue(kF1, "SNE r, p0, {-2, 1, 2, 0};", {0, 1, 0, 1});
  expectValue(kF1, "SGT r, p0, {-2, -1, 3, 0};", {0, 1, 0, 0});
  expectValue(kF1, "SLE r, p0, {-2, -1, 3, 0};", {1, 0, 1, 0});
  expectValue(kF1, "SNE r, p3.z, p3.w;", {0, 0, 0, 0}); // -0 and 0
  expectValue(kF1, "STR r, p0, p0; SFL r.y, p0, p0;", {1, 0, 1, 1});
  expectValue(kV2, "SSG r, p0;", {-1, 0, 1, 0});
  expectValue(kV2, "SSG r, p3;", {1, -1, 0, 0});
}

TEST(NvValues, Vectors) {
  expectValue(kF1, "X2D r, p1, p2, {1, 2, 3, 4};", {1 + 0.5f - 0.5f, 2 + 1.5f - 1, 1, 2.5f});
  expectValue(kF1, "MOV r, 7.0; RFL r, p1, p2;", {0.25f, 1.75f, 0.5f, 7});
  expectValue(kF2, "DIV r, p1, p2.x;", {2, 4, 6, 8});
  expectValue(kF2, "DIV r, p0, p3.w;", {-kInf, kNan, kInf, kNan});
  expectValue(kF2, "DP2 r, p1, p2;", {0, 0, 0, 0});
  expectValue(kF2, "DP2A r, p1, p2, p1.z;", {3, 3, 3, 3});
  expectValue(kF2, "NRM r, p1;", {0.267261237f, 0.534522474f, 0.801783681f, 1.06904495f});
  expectValue(kF2, "MOV_SSAT r, p0;", {-1, 0, 1, -1});
  expectValue(kF1, "MOV r, 7.0; SCS r, p2.x;", {0.87758255f, 0.47942543f, 7, 7});
  expectValue(kF1, "MOV r, -|p0|;", {-2, -0.0f, -2, kNan});
  expectValue(kF1, "SWZ r, |p0|, -x, z, 0, -1;", {-2, 2, 0, -1});
  expectValue(kV2, "RCC r.x, p1.y; RCC r.y, p3.x; RCC r.z, p3.z; RCC r.w, p3.y;",
              {0.5f, 5.42101086e-20f, -1.84467441e+19f, -5.42101086e-20f});
}

TEST(NvValues, Packing) {
  expectValue(kF1, "PK2H s, p2; UP2H r, s.x;", {0.5f, -0.25f, 0.5f, -0.25f});
  expectValue(kF1, "PK2H s, p3; UP2H r, s.x;", {kInf, -kInf, kInf, -kInf});
  expectValue(kF1, "PK2H s, p4; UP2H r, s.x;", {0, kInf, 0, kInf});
  expectValue(kF1, "PK2US s, p2; UP2US r, s.x;", {0.500007629f, 0, 0.500007629f, 0});
  expectValue(kF1, "PK4B s, p2; UP4B r, s.x;", {0.503937006f, -0.251968503f, 1, 0.102362201f});
  expectValue(kF1, "PK4B s, p0; UP4B r, s.x;", {-1.00787401f, 0, 1, -1.00787401f});
  expectValue(kF1, "PK4UB s, p2; UP4UB r, s.x;", {0.501960814f, 0, 1, 0.101960793f});
  expectValue(kF1, "PK4UB s, p0; UP4UB r, s.x;", {0, 0, 1, 0});
  // The bits are those of a denormal: a MOV keeps them, and an addition does not.
  expectValue(kF1, "PK4UB s, {1, 0, 0, 0}; MOV t, s; UP4UB r, t.x;", {1, 0, 0, 0});
  expectValue(kF1, "PK4UB s, {1, 0, 0, 0}; MOVC t (EQ), s; UP4UB r, t.x;", {1, 0, 0, 0});
  expectValue(kF1, "PK4UB s, {1, 0, 0, 0}; ADD t, s, p3.w; UP4UB r, t.x;", {0, 0, 0, 0});
}

TEST(NvValues, KillByATest) {
  const auto killed = [](const std::string &statements) {
    const ir::Program program = load(kF2, statements + "\nMOV result.color, p0;");
    return ir::evaluate(program, inputs()).killed;
  };
  EXPECT_TRUE(killed("MOVC r, p0; KIL LT.x;"));
  EXPECT_FALSE(killed("MOVC r, p0; KIL LT.y;"));
  EXPECT_TRUE(killed("MOVC r, p0; KIL NE.w;"));
  EXPECT_FALSE(killed("MOVC r, p0; KIL GE.w;"));
  EXPECT_TRUE(killed("KIL TR;"));
  EXPECT_FALSE(killed("MOVC r, p0; IF EQ.x; KIL TR; ENDIF;"));
  EXPECT_FALSE(killed("MOVC r, p0; IF EQ.x; KIL -1.0; ENDIF;"));
  EXPECT_TRUE(killed("MOVC r, p0; IF LT.x; KIL -1.0; ENDIF;"));
}

TEST(NvValues, Blocks) {
  const std::string kIf = "MOVC s, p0; IF ";
  const std::string kElse = "; MOV r, 1.0; ELSE; MOV r, 2.0; ENDIF;";
  expectValue(kF2, kIf + "GT.z" + kElse, {1, 1, 1, 1});
  expectValue(kF2, kIf + "GT" + kElse, {1, 1, 1, 1}); // any
  expectValue(kF2, kIf + "GT.x" + kElse, {2, 2, 2, 2});
  expectValue(kF2, kIf + "GE.w" + kElse, {2, 2, 2, 2}); // NaN
  expectValue(kF2, kIf + "FL" + kElse, {2, 2, 2, 2});
  // Writes inside the block do not change which part runs.
  expectValue(kF2,
              "MOV r, 0.0; MOVC s, p0; IF GT.z; MOVC s, -1.0; ADD r, r, 1.0; ELSE; ADD r, r, 10.0; "
              "ENDIF;",
              {1, 1, 1, 1});
  expectValue(
      kF2,
      "MOV r, 0.0; MOVC s, p0; IF GT.z; IF GT.x; ADD r, r, 1.0; ELSE; ADD r, r, 2.0; ENDIF; "
      "ELSE; IF TR; ADD r, r, 4.0; ENDIF; ENDIF; ADD r, r, 8.0;",
      {10, 10, 10, 10});
}

TEST(NvValues, Loops) {
  const auto sum = [](const char *operand, float expected) {
    expectValue(kF2, std::string("MOV r, 0.0; REP ") + operand + "; ADD r, r, 1.0; ENDREP;",
                {expected, expected, expected, expected});
  };
  sum("p5", 3);
  sum("p5.w", 2);
  sum("p5.y", 0);
  sum("p0", 0); // -2
  sum("-p0", 2);
  sum("|p0|", 2);
  sum("p0.w", 0); // NaN
  sum("300", 300);
  expectValue(kF2, "MOV r, 0.0; REP 300; REP 200; ADD r, r, 1.0; ENDREP; ENDREP;",
              {60000, 60000, 60000, 60000});
  expectValue(kF2,
              "MOV r, 0.0; LOOP {255, 0, 1}; ADD r, r, 1.0; SGEC s.x, r, 7.0; BRK (NE.x); ENDLOOP;",
              {7, 7, 7, 7});
  expectValue(kF2,
              "MOV r, 0.0; REP 3; REP 10; ADD r, r, 1.0; SGEC s.x, r, 5.0; IF NE.x; BRK; ENDIF; "
              "ENDREP; ADD r, r, 10.0; ENDREP;",
              {37, 37, 37, 37});
  // No program runs forever: all loops together run 65,000 iterations.
  expectValue(kF2, "MOV r, 0.0; REP 1e9; REP 1e9; ADD r, r, 1.0; ENDREP; ENDREP;",
              {64999, 64999, 64999, 64999});
}

TEST(NvValues, Subroutines) {
  expectValue(kF2,
              "MOV r, 1.0; CAL a; ADD r, r, 10.0; MOV result.color, r; RET; a: ADD r, r, r; RET;",
              {12, 12, 12, 12});
  expectValue(
      kF2,
      "MOVC r, p0; CAL a (GT.x); CAL b (GT.z); MOV result.color, r; RET; a: MOV r, 5.0; RET; "
      "b: MOV r, 6.0; RET;",
      {6, 6, 6, 6});
  // A RET under a condition, or in a loop, leaves only the subroutine.
  expectValue(kF2,
              "MOVC r, p0; CAL a; MOV result.color, r; RET; a: MOV r, 1.0; RET (LT.x); MOV r, 2.0;",
              {1, 1, 1, 1});
  expectValue(kF2,
              "MOV r, 0.0; CAL a; ADD r, r, 100.0; MOV result.color, r; RET; a: REP 10; "
              "ADD r, r, 1.0; SGEC s.x, r, 3.0; IF NE.x; RET; ENDIF; ENDREP; ADD r, r, 50.0; RET;",
              {103, 103, 103, 103});
  expectValue(kF2, "MOV result.color, 1.0; RET; MOV result.color, 2.0;", {1, 1, 1, 1});
  expectValue(kF2, "a: MOV result.color, 1.0; RET; main: MOV result.color, 2.0; RET;",
              {2, 2, 2, 2});
}

TEST(NvValues, Branches) {
  expectValue(
      kV2, "MOV r, 1.0; MOVC s, p0; BRA a (LT.x); MOV r, 2.0; a: MOV result.texcoord[0], r; RET;",
      {1, 1, 1, 1});
  expectValue(
      kV2, "MOV r, 1.0; MOVC s, p0; BRA a (GT.x); MOV r, 2.0; a: MOV result.texcoord[0], r; RET;",
      {2, 2, 2, 2});
  // A loop.
  expectValue(kV2,
              "MOV r, 0.0; a: ADD r, r, 1.0; SLTC s, r, 10.0; BRA a (NE.x); "
              "MOV result.texcoord[0], r; RET;",
              {10, 10, 10, 10});
  // A loop with two ways in.
  expectValue(kV2,
              "MOV r, 0.0; MOVC s, p0; BRA b (LT.x); a: ADD r, r, 10.0; b: ADD r, r, 1.0; "
              "SLTC s, r, 30.0; BRA a (NE.x); MOV result.texcoord[0], r; RET;",
              {34, 34, 34, 34});
  // A loop in a subroutine that is called twice.
  expectValue(kV2,
              "MOV r, 0.0; CAL a; CAL a; MOV result.texcoord[0], r; RET; a: MOV s, 0.0; "
              "b: ADD r, r, 1.0; ADD s, s, 1.0; SLTC t, s, 4.0; BRA b (NE.x); RET;",
              {8, 8, 8, 8});
  // A loop without an end.
  const ir::Program endless = load(kV2, "a: ADD r, r, 1.0; BRA a;");
  EXPECT_FALSE(ir::evaluate(endless, inputs()).killed);
}

TEST(NvValues, AddressVectors) {
  const std::string kArray =
      "ADDRESS A, B; PARAM c[] = {10, 11, 12, 13, 14, 15, 16, 17, 18, 19};\n";
  expectValue(kV2,
              kArray + "ARL A, {2.9, 3.5, -1.5, 4}; MOV r.x, c[A.x]; MOV r.y, c[A.y + 1]; "
                       "MOV r.z, c[A.z + 2]; MOV r.w, c[A.w - 1];",
              {12, 14, 10, 13});
  expectValue(kV2,
              kArray + "ARR A, {0.5, 1.5, 2.5, 3.4}; MOV r.x, c[A.x]; MOV r.y, c[A.y]; "
                       "MOV r.z, c[A.z]; MOV r.w, c[A.w];",
              {10, 12, 12, 13});
  expectValue(kV2,
              kArray + "ARL A, {1, 2, 3, 4}; ARA B, A; MOV r.x, c[B.x]; MOV r.y, c[B.y]; "
                       "MOV r.z, c[B.z]; MOV r.w, c[B.w];",
              {14, 16, 14, 16});
  expectValue(kV2, kArray + "ARLC A, p0; MOV r, 0.0; MOV r (LT), 1.0;", {1, 0, 0, 0});
  expectValue(kV2,
              kArray + "ARL A, 5.0; MOVC s, p0; ARL A (LT), 1.0; MOV r.x, c[A.x]; MOV r.y, c[A.y];",
              {11, 15, 0, 0});
  expectValue(kV2, kArray + "ARL A.x, p0.w; MOV r, c[A.x];", {10, 10, 10, 10}); // NaN
}

TEST(NvValues, TheStackOfAddresses) {
  const std::string kArray =
      "ADDRESS A, B; PARAM c[] = {10, 11, 12, 13, 14, 15, 16, 17, 18, 19};\n";
  expectValue(kV3,
              kArray +
                  "ARL A, {1, 2, 3, 4}; PUSHA A; ARL A, 5.0; PUSHA A; ARL A, 9.0; MOV r.x, c[A.x]; "
                  "POPA B; MOV r.y, c[B.y]; POPA A; MOV r.z, c[A.z]; MOV r.w, c[A.x];",
              {19, 15, 13, 11});
}

TEST(NvValues, SamplesOfGivenLevels) {
  expectValue(kF2, "TXL r, p1, texture[0], 2D;", {1, 2, 4, 0});
  expectValue(kF1, "TXD r, p1, p2, {0, 3, 0, 0}, texture[0], 2D;", {1, 2, 30.5f, 0});
  expectValue(kV3, "TEX r, p1, texture[0], 2D;", {1, 2, 0, 0});
  expectValue(kV3, "TXP r, p1, texture[0], 2D;", {0.25f, 0.5f, 0, 0});
  expectValue(kV3, "TXB r, p1, texture[0], 2D;", {1, 2, 4, 0}); // NVIDIA's driver: level 0
}

TEST(NvValues, Derivatives) {
  const ir::Program program = load(
      kF1, "ATTRIB c = fragment.texcoord[0]; MUL r, c, c; DDX s, r; DDY t, r; MOV s.zw, t.xyxy; "
           "MOV result.color, s;");
  std::array<ir::Inputs, 4> quad;
  std::array<std::array<Vec4, 1>, 4> attributes;
  for (std::size_t i = 0; i < 4; ++i) {
    attributes[i] = {Vec4{2.5f + float(i & 1), 4.5f + float(i >> 1), 0, 1}};
    quad[i] = inputs();
    quad[i].attributes = attributes[i];
  }
  for (const ir::Evaluation &evaluation : ir::evaluateQuad(program, quad))
    expectNear(outputOf(program, evaluation), {6, 0, 0, 10}, 2e-6f, "derivatives");
}

TEST(NvValues, Facing) {
  const ir::Program program = load(kF2, "MOV result.color, fragment.facing;");
  ASSERT_EQ(program.attributes.size(), 1u);
  EXPECT_EQ(program.attributes[0].kind, ir::AttributeKind::Facing);
}

} // namespace
} // namespace arbiter::fp
