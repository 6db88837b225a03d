#pragma once
#include <algorithm>
#include <gtest/gtest.h>
#include <string>

#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/inputs.h"
#include "fp_compiler/testing/random.h"

/// Checks of the contract that every pass must fulfil, on handwritten and on random programs.
namespace arbiter::fp::opt {

/// Returns the last instruction as text.
inline std::string last(const ir::Program &program) { return ir::print(program.code.back()); }

/// Returns the number of instructions with that opcode, or -1 if there is a loop.
inline int countWithoutLoops(const ir::Program &program, ir::Opcode op) {
  if (ir::hasLoops(program))
    return -1;
  return int(std::count_if(program.code.begin(), program.code.end(),
                           [op](const auto &instruction) { return instruction.op == op; }));
}

/// Wraps a pass, whether it takes a numerics mode or not.
class Pass {
public:
  Pass(bool (*inEveryMode)(ir::Program &)) : m_inEveryMode(inEveryMode) {}
  Pass(bool (*inMode)(ir::Program &, Numerics)) : m_inMode(inMode) {}
  bool operator()(ir::Program &program, Numerics numerics) const {
    return m_inMode ? m_inMode(program, numerics) : m_inEveryMode(program);
  }

private:
  bool (*m_inEveryMode)(ir::Program &) = nullptr;
  bool (*m_inMode)(ir::Program &, Numerics) = nullptr;
};

/// Runs a pass and checks its contract. The program stays valid and keeps its meaning to the bit.
/// It changes if and only if the pass says so, and a second run changes nothing. Returns the pass's
/// result.
inline bool runChecked(Pass pass, ir::Program &program, const std::string &context = "",
                       Numerics numerics = Numerics::Host) {
  const ir::Program before = program;
  const bool changed = pass(program, numerics);
  const std::string text = context + " " + std::string(kNumericsNames[std::size_t(numerics)]) +
                           "\nbefore:\n" + ir::print(before) + "after:\n" + ir::print(program);
  for (const std::string &problem : ir::validate(program))
    ADD_FAILURE() << problem << text;
  for (std::uint64_t pixel = 0; pixel < 6; ++pixel) {
    const testing::Made made = {pixel, numerics, pixel >= 4};
    EXPECT_TRUE(testing::same(testing::outcome(before, made), testing::outcome(program, made)))
        << "meaning changed, pixel " << pixel << text;
    if (before.language != ir::Language::ArbFragment)
      continue;
    const auto quad = testing::quadOutcome(before, made), now = testing::quadOutcome(program, made);
    for (std::size_t lane = 0; lane < 4; ++lane)
      EXPECT_TRUE(testing::same(quad[lane], now[lane]))
          << "meaning changed, pixel " << pixel << ", neighbour " << lane << text;
  }
  EXPECT_EQ(changed, ir::print(before) != ir::print(program)) << text;
  ir::Program again = program;
  EXPECT_FALSE(pass(again, numerics)) << "not a fixed point" << text << "again:\n"
                                      << ir::print(again);
  return changed;
}

/// Checks the contract on random programs in every mode. Half of them have special values, and half
/// are vertex programs. The pass must find work in both.
/// \param prepare modifies each program so that the pass has something to do
inline void runOnRandomPrograms(
    Pass pass, int count = 300, void (*prepare)(ir::Program &) = [](ir::Program &) {}) {
  int changed = 0, changedVertex = 0;
  for (std::uint64_t seed = 0; seed < std::uint64_t(count); ++seed) {
    testing::RandomOptions options;
    options.wild = seed & 1;
    options.maxInstructions = 40;
    const auto numerics = Numerics(seed / 2 % kNumericsNames.size());
    ir::Program program = testing::randomProgram(seed + 10000, options);
    prepare(program);
    changed += runChecked(pass, program, "seed " + std::to_string(seed), numerics);
    program = testing::randomVertexProgram(seed + 20000, options);
    prepare(program);
    changedVertex += runChecked(pass, program, "vertex, seed " + std::to_string(seed), numerics);
    if (::testing::Test::HasFailure())
      return;
  }
  EXPECT_GT(changed, 0) << "the pass never had anything to do";
  EXPECT_GT(changedVertex, 0) << "the pass never had anything to do in vertex programs";
}

} // namespace arbiter::fp::opt
