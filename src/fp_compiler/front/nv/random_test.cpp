// Tests generated programs under NVIDIA's options: they load, their code is valid, and the passes
// do not change what they compute. A text with a token removed or doubled is refused, or computes
// too.
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "fp_compiler/front/testing/nvidia.h"
#include "fp_compiler/front/testing/test_support.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/random_nv.h"
#include "fp_compiler/testing/specials.h"

namespace arbiter::fp {
namespace {

using ir::NvOption;
using ir::Vec4;

ir::Inputs inputs(std::span<const Vec4> attributes) {
  ir::Inputs given;
  given.attributes = attributes;
  given.parameter = [](const ir::Parameter &parameter) -> Vec4 {
    using testing::kInf, testing::kNan;
    constexpr Vec4 kRows[] = {
        {-2, 0, 2, kNan}, {1, 2, 3, 4}, {0.5f, -0.25f, 1.75f, -0.0f}, {kInf, -kInf, 1e30f, 7}};
    return kRows[parameter.index & 3];
  };
  given.texture = [](const ir::Sample &sample) {
    return Vec4{sample.coordinate[0], 0.5f, sample.lod.value_or(-1), 1};
  };
  return given;
}

bool same(const Vec4 &a, const Vec4 &b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i]) &&
        !(std::isnan(a[i]) && std::isnan(b[i])))
      return false;
  return true;
}

TEST(NvRandom, PassesKeepTheMeaning) {
  constexpr std::uint32_t kPrograms = 150;
  std::uint32_t compared = 0;
  for (std::uint32_t seed = 0; seed < 4 * kPrograms; ++seed) {
    const std::string text =
        testing::randomNvProgram(seed, {.vertex = (seed & 1) != 0,
                                        .option = seed & 2 ? NvOption::Second : NvOption::First,
                                        .wild = (seed & 4) != 0,
                                        .loopDerivatives = true,
                                        .statements = 24});
    CheckResult result = testing_support::check(text, testing_support::offering(2));
    ASSERT_TRUE(result.ok()) << result.errorString(text) << text;
    ir::Program program = std::move(*result.program);
    ASSERT_TRUE(ir::validate(program).empty()) << text;
    const std::vector<Vec4> attributes(program.attributes.size(), Vec4{0.75f, -1.5f, 2, 1});
    const ir::Evaluation before = ir::evaluate(program, inputs(attributes));
    optimise(program);
    ASSERT_TRUE(ir::validate(program).empty()) << text;
    const ir::Evaluation after = ir::evaluate(program, inputs(attributes));
    ASSERT_EQ(before.killed, after.killed) << text;
    for (std::size_t i = 0; i < before.outputs.size(); ++i)
      ASSERT_TRUE(same(before.outputs[i], after.outputs[i])) << text << ir::print(program);
    compared += before.killed ? 0 : 1;
  }
  EXPECT_GT(compared, kPrograms);
}

TEST(NvRandom, TextsWithATokenLessOrMore) {
  const std::string texts[] = {
      "!!ARBfp1.0\nOPTION NV_fragment_program2;\nSHORT TEMP a, b;\nLOOP {4, 0, 1};\n"
      "ADDHC_SSAT a.xy (GT.xxzw), |a|, -|fragment.texcoord[A0.x + 1]|;\nIF EQ.x;\nBRK (LT);\n"
      "CAL sub (NE.y);\nELSE;\nKIL GE;\nENDIF;\nENDLOOP;\nREP -program.local[0];\nENDREP;\n"
      "MOV result.color, a;\nRET;\nsub:\nRFL b, a, a;\nRET (TR);\nEND\n",
      "!!ARBvp1.0\nOPTION NV_vertex_program3;\nADDRESS A;\nTEMP r;\nstart:\nARLC A.xw (EQ), "
      "vertex.color;\nPUSHA A;\nPOPA A;\nMOVC1 r, vertex.attrib[A.y - 1];\nBRA start (LT1.z);\n"
      "TXL result.texcoord[A.x + 2], r, texture[0], CUBE;\nMOV result.position, r;\nEND\n"};
  int loaded = 0, refused = 0;
  for (const std::string &text : texts)
    testing_support::forEachTokenEdit(text, [&](const std::string &edited) {
      const CheckResult result = testing_support::check(edited, testing_support::offering(2));
      if (!result.ok()) {
        ++refused;
        EXPECT_LE(std::size_t(result.errorPosition()), edited.size()) << edited;
        return;
      }
      ++loaded;
      EXPECT_TRUE(ir::validate(*result.program).empty()) << edited;
      const std::vector<Vec4> attributes(result.program->attributes.size(), Vec4{1, 1, 1, 1});
      static_cast<void>(ir::evaluate(*result.program, inputs(attributes)));
    });
  EXPECT_GT(refused, 100);
  EXPECT_GT(loaded, 0);
}

} // namespace
} // namespace arbiter::fp
