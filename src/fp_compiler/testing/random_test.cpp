#include "fp_compiler/testing/random.h"

#include <gtest/gtest.h>
#include <set>

#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/inputs.h"

namespace arbiter::fp::testing {
namespace {

Limits roomy() {
  Limits limits;
  limits.api = {4096, 4096, 4096, 4096, 256, 256, 32};
  limits.native = limits.api;
  limits.localParameters = limits.envParameters = 256;
  limits.textureCoords = limits.textureImageUnits = limits.textureUnits = 8;
  limits.programMatrices = 8;
  limits.drawBuffers = 4;
  return limits;
}

TEST(RandomProgram, IsValidAndReproducible) {
  std::set<ir::Opcode> seen;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    RandomOptions options;
    options.wild = seed & 1;
    const ir::Program program = randomProgram(seed, options);
    for (const std::string &problem : ir::validate(program))
      ADD_FAILURE() << "seed " << seed << ": " << problem;
    EXPECT_EQ(ir::print(program), ir::print(randomProgram(seed, options)));
    for (const ir::Instruction &instruction : program.code)
      seen.insert(instruction.op);
  }
  EXPECT_EQ(int(seen.size()), ir::kFragmentOpcodeCount);
}

TEST(Spell, TextMeansTheProgram) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const ir::Program program = randomProgram(seed);
    const std::string text = spell(program, seed);
    const CheckResult checked = checkFragmentProgram(text, {roomy(), LimitPolicy::Enforce});
    ASSERT_TRUE(checked.ok()) << "seed " << seed << "\n"
                              << checked.errorString(text) << "\n"
                              << text;
    for (const std::string &problem : ir::validate(*checked.program))
      ADD_FAILURE() << "seed " << seed << ": " << problem << "\n" << text;
    for (std::uint64_t pixel = 0; pixel < 4; ++pixel) {
      const Outcome expected = outcome(program, pixel);
      EXPECT_TRUE(same(expected, outcome(*checked.program, pixel)))
          << "seed " << seed << "\n"
          << text << ir::print(program) << ir::print(*checked.program);
    }
  }
}

} // namespace
} // namespace arbiter::fp::testing
