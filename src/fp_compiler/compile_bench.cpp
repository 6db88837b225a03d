/// Measures how many program texts a second one core parses, checks, counts for a card and compiles
/// to GLSL. It prints a table and tests nothing.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "fp_compiler/compilation.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/testing/random.h"

namespace {

using namespace arbiter::fp;

constexpr int kPrograms = 256;

/// Returns tame programs of exactly that many instructions, laid out as a person might.
std::vector<std::string> texts(int instructions) {
  std::vector<std::string> result;
  testing::RandomOptions options;
  options.minInstructions = options.maxInstructions = instructions;
  for (std::uint64_t seed = 0; result.size() < kPrograms; ++seed) {
    const ir::Program program = testing::randomProgram(seed, options);
    if (int(program.code.size()) >= instructions)
      result.push_back(testing::spell(program, seed));
  }
  return result;
}

CompileOptions optionsOf(std::string_view profile) {
  CompileOptions options;
  options.limits = hw::findBuiltin(profile)->fragment;
  options.policy = LimitPolicy::Report; // a long program must be checked to its end
  return options;
}

template <typename Work>
void programs(benchmark::State &state, const std::vector<std::string> &texts, Work work) {
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(work(texts[next]));
    next = (next + 1) % texts.size();
  }
  state.SetItemsProcessed(state.iterations());
}

/// Measures parse and check; with `model` also the native count of the profile's model, if it has
/// one.
void check(benchmark::State &state, std::string_view profile, bool model) {
  CompileOptions options = optionsOf(profile);
  if (!model)
    options.limits.nativeModel = NativeModel::Documented;
  programs(state, texts(int(state.range(0))),
           [&](const std::string &text) { return checkFragmentProgram(text, options).ok(); });
}

void glsl(benchmark::State &state) {
  const CompilationInput input = {ir::Language::ArbFragment, optionsOf("r300"), {}};
  programs(state, texts(int(state.range(0))),
           [&](const std::string &text) { return compile(input, text).glsl.text.size(); });
}

} // namespace

BENCHMARK_CAPTURE(check, parse, "r300", false)->Arg(10)->Arg(30)->Arg(96);
BENCHMARK_CAPTURE(check, r300, "r300", true)->Arg(10)->Arg(30)->Arg(96);
BENCHMARK_CAPTURE(check, nv30, "nv30", true)->Arg(30);
BENCHMARK_CAPTURE(check, i915, "i915", true)->Arg(30);
BENCHMARK(glsl)->Arg(10)->Arg(30)->Arg(96);
BENCHMARK_MAIN();
