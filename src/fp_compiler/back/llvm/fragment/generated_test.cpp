// Tests hundreds of generated programs and all golden programs against the interpreter, to the bit.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "fp_compiler/back/llvm/testing/compare.h"
#include "fp_compiler/back/llvm/testing/machine.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_nv.h"

namespace arbiter::fp::llvm_back {
namespace {

class ProgramsTest : public ::testing::TestWithParam<std::tuple<std::string, Numerics>> {};

ir::Program generated(std::uint64_t seed, bool vertex, bool wild) {
  testing::RandomOptions options;
  options.wild = wild;
  options.maxInstructions = 24;
  return vertex ? testing::randomVertexProgram(seed, options)
                : testing::randomProgram(seed, options);
}

TEST_P(ProgramsTest, GeneratedOnesAgree) {
  const auto &[cpu, numerics] = GetParam();
  Comparison comparison(numerics, cpu);
  constexpr std::uint64_t kPrograms = 90;
  for (std::uint64_t seed = 0; seed < kPrograms; ++seed) {
    const bool vertex = seed % 3 == 0, wild = seed % 2 == 1;
    ir::Program program = generated(seed, vertex, wild);
    if (seed % 5 == 0)
      opt::run(program, numerics);
    ASSERT_EQ(comparison.run(program, seed, wild), "") << "seed " << seed;
  }
  EXPECT_GT(comparison.compared, 5000);
  EXPECT_GT(comparison.killed, 20);
  EXPECT_LT(comparison.edges, comparison.compared / 40) << "much of the test is left out";
}

/// Returns options with limits that allow everything in the goldens.
CompileOptions roomy() {
  CompileOptions options;
  options.policy = LimitPolicy::Report;
  Limits &limits = options.limits;
  limits.localParameters = limits.envParameters = 256;
  limits.textureCoords = limits.textureUnits = 8;
  limits.textureImageUnits = 16;
  limits.programMatrices = 8;
  limits.programMatrixStackDepth = 4;
  limits.drawBuffers = 4;
  limits.api.addressRegisters = 1;
  return options;
}

/// Tests programs under NVIDIA's options: loops, packing, derivatives, addresses.
TEST_P(ProgramsTest, GeneratedOnesOfNvidiasOptionsAgree) {
  const auto &[cpu, numerics] = GetParam();
  Comparison comparison(numerics, cpu);
  CompileOptions limits = roomy();
  limits.limits.nvOptions = 2;
  limits.limits.api.addressRegisters = 2;
  constexpr std::uint64_t kPrograms = 180; // most of them have no loop left after the passes
  int loops = 0;
  for (std::uint64_t seed = 0; seed < kPrograms; ++seed) {
    const bool vertex = seed % 3 == 0, wild = seed % 2 == 1;
    const std::string text = testing::randomNvProgram(
        seed, {.vertex = vertex,
               .option = seed % 5 == 0 ? ir::NvOption::First : ir::NvOption::Second,
               .wild = wild,
               .textures = !vertex,
               .loopDerivatives = true,
               .statements = 14});
    const CheckResult checked = checkProgram(*languageOfText(text), text, limits);
    ASSERT_TRUE(checked.ok()) << checked.errorString(text) << text;
    ir::Program program = *checked.program;
    opt::run(program, numerics);
    loops += ir::hasLoops(program) ? 1 : 0;
    ASSERT_EQ(comparison.run(program, seed, wild), "") << "seed " << seed << "\n" << text;
  }
  EXPECT_GT(comparison.compared, 4000);
  EXPECT_GT(comparison.killed, 20);
  EXPECT_GT(loops, 20);
  EXPECT_LT(comparison.edges, comparison.compared / 40) << "much of the test is left out";
}

std::string textOf(const std::filesystem::path &path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST_P(ProgramsTest, GoldenOnesAgree) {
  const auto &[cpu, numerics] = GetParam();
  Comparison comparison(numerics, cpu);
  int programs = 0;
  for (const auto &entry : std::filesystem::directory_iterator(GOLDEN_PROGRAMS)) {
    const std::string extension = entry.path().extension();
    if (extension != ".fp" && extension != ".vp")
      continue;
    const std::string text = textOf(entry.path());
    const auto language = languageOfText(text);
    ASSERT_TRUE(language) << entry.path();
    const CheckResult checked = checkProgram(*language, text, roomy());
    if (!checked.ok())
      continue; // valid under other limits; golden-check covers it
    ++programs;
    for (const bool wild : {false, true})
      ASSERT_EQ(comparison.run(*checked.program, std::uint64_t(programs), wild), "")
          << entry.path();
  }
  EXPECT_GT(programs, 30);
}

INSTANTIATE_TEST_SUITE_P(All, ProgramsTest,
                         ::testing::Combine(::testing::ValuesIn(testedCpus()),
                                            ::testing::Values(Numerics::Host, Numerics::Legacy)),
                         [](const auto &param) {
                           return nameInTests(std::get<0>(param.param)) +
                                  (std::get<1>(param.param) == Numerics::Host ? "Host" : "Legacy");
                         });

} // namespace
} // namespace arbiter::fp::llvm_back
