#include "fp_compiler/hw/r300/compile.h"

#include <gtest/gtest.h>

#include "fp_compiler/ati/lower.h"
#include "fp_compiler/hw/r300/legality.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_ati.h"

namespace arbiter::fp::hw::r300 {
namespace {

void expectLegal(const ir::Program &program, const CompileOptions &options, std::uint64_t seed) {
  const Code code = compile(program, options);
  for (const Fault &fault : faults(code, program))
    ADD_FAILURE() << "seed " << seed << ": " << fault.text << "\n" << ir::print(program);
}

TEST(R300Compile, RandomProgramsAreLegal) {
  for (std::uint64_t seed = 0; seed < 500 && !HasFailure(); ++seed) {
    testing::RandomOptions options;
    options.wild = seed % 2 == 0;
    options.maxInstructions = seed % 5 == 0 ? 60 : 16;
    expectLegal(testing::randomProgram(seed, options), {seed % 4 < 2}, seed);
  }
}

TEST(R300Compile, AtiShadersAreLegal) {
  for (std::uint64_t seed = 0; seed < 300 && !HasFailure(); ++seed) {
    ir::Program program = ati::lower(testing::randomAtiShader(seed), {});
    program.options.colorSum = seed % 2 == 0;
    program.options.fog = ir::FogMode(seed / 2 % 4);
    expectLegal(program, {}, seed);
  }
}

TEST(R300Compile, AnEmptyProgramIsOneNodeWithOneIdlePair) {
  const Code code = compile({}, {});
  ASSERT_EQ(code.nodes.size(), 1u);
  ASSERT_EQ(code.pairs.size(), 1u);
  EXPECT_EQ(code.pairs[0].rgb.cause, Cause::EmptyNode);
  EXPECT_TRUE(faults(code).empty());
}

} // namespace
} // namespace arbiter::fp::hw::r300
