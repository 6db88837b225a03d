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
  limits.api = {4096, 4096, 4096, 4096, 256, 256, 32, 4};
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
    options.unwritten = seed & 2;
    const ir::Program program = randomProgram(seed, options);
    for (const std::string &problem : ir::validate(program))
      ADD_FAILURE() << "seed " << seed << ": " << problem;
    EXPECT_EQ(ir::print(program), ir::print(randomProgram(seed, options)));
    for (const ir::Instruction &instruction : program.code)
      seen.insert(instruction.op);
  }
  EXPECT_EQ(int(seen.size()), ir::kFragmentOpcodeCount);
}

TEST(RandomProgram, VertexProgramsTooAndTheyUseAddresses) {
  std::set<ir::Opcode> seen;
  int relative = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    RandomOptions options;
    options.wild = seed & 1;
    options.unwritten = seed & 2;
    const ir::Program program = randomVertexProgram(seed, options);
    for (const std::string &problem : ir::validate(program))
      ADD_FAILURE() << "seed " << seed << ": " << problem;
    EXPECT_EQ(ir::print(program), ir::print(randomVertexProgram(seed, options)));
    for (const ir::Instruction &instruction : program.code) {
      seen.insert(instruction.op);
      EXPECT_FALSE(instruction.dst.saturate) << "vertex programs have no _SAT";
      for (const ir::Operand &operand : instruction.src)
        relative += operand.relative;
    }
  }
  for (int op = 0; op < ir::kOpcodeCount; ++op)
    EXPECT_EQ(seen.count(ir::Opcode(op)), ir::info(ir::Opcode(op)).has(ir::FragmentOnly) ? 0u : 1u)
        << ir::info(ir::Opcode(op)).mnemonic;
  EXPECT_GT(relative, 200);
}

TEST(Spell, VertexTextMeansTheProgram) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const ir::Program program = randomVertexProgram(seed);
    const std::string text = spell(program, seed);
    const CheckResult checked =
        checkProgram(ir::Language::ArbVertex, text, {roomy(), LimitPolicy::Enforce});
    ASSERT_TRUE(checked.ok()) << "seed " << seed << "\n"
                              << checked.errorString(text) << "\n"
                              << text;
    for (const std::string &problem : ir::validate(*checked.program))
      ADD_FAILURE() << "seed " << seed << ": " << problem << "\n" << text;
    for (std::uint64_t vertex = 0; vertex < 4; ++vertex)
      EXPECT_TRUE(same(outcome(program, vertex), outcome(*checked.program, vertex)))
          << "seed " << seed << "\n"
          << text << ir::print(program) << ir::print(*checked.program);
  }
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
