/// Measures the interpreter's speed in each mode, in instructions a second, on generated programs
/// of 30 instructions. It prints a table and tests nothing.
#include <benchmark/benchmark.h>
#include <vector>

#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/testing/random.h"

namespace {
using namespace arbiter::fp;

void evaluate(benchmark::State &state) {
  const auto numerics = Numerics(state.range(0));
  std::vector<ir::Program> programs;
  for (std::uint64_t seed = 0; seed < 64; ++seed) {
    testing::RandomOptions options;
    options.minInstructions = options.maxInstructions = 30;
    options.kills = false;
    programs.push_back(testing::randomProgram(seed, options));
  }
  const std::vector<ir::Vec4> attributes(16, ir::Vec4{0.25f, 0.75f, 1.5f, 1.0f});
  ir::Inputs inputs;
  inputs.attributes = attributes;
  inputs.parameter = [](const ir::Parameter &) { return ir::Vec4{0.5f, -1.25f, 2.0f, 1.0f}; };
  inputs.texture = [](const ir::Sample &) { return ir::Vec4{0.25f, 0.5f, 0.75f, 1.0f}; };
  inputs.numerics = numerics;
  std::size_t at = 0, instructions = 0;
  for (auto _ : state) {
    const ir::Program &program = programs[at++ % programs.size()];
    benchmark::DoNotOptimize(ir::evaluate(program, inputs));
    instructions += program.code.size();
  }
  state.SetItemsProcessed(std::int64_t(instructions));
  state.SetLabel(std::string(kNumericsNames[std::size_t(state.range(0))]));
}
BENCHMARK(evaluate)->DenseRange(0, int(kNumericsNames.size()) - 1);
} // namespace

BENCHMARK_MAIN();
