#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include <benchmark/benchmark.h>

#include "fp_compiler/back/llvm/code/cpu.h"
#include "fp_compiler/back/llvm/testing/guarded_texture.h"
#include "fp_compiler/back/llvm/testing/sample_harness.h"

/// Measures lookups in nanoseconds for a pixel on one thread, with stores of four floats.
/// `--benchmark_filter=/avx2` and similar select lesser processors. SAMPLE_ASSEMBLY=name prints the
/// machine code of a case instead.
namespace arbiter::fp::llvm_back::testing {
namespace {

constexpr int kSize = 512;
constexpr int kPixels = 1024; ///< per call: the results stay in the cache

/// The texel steps between neighbouring pixels.
enum class Path { OneToOne, Magnified, Rotated, Minified, Scattered };

struct Bench {
  const char *name;
  abi::Filter filter = abi::Filter::Nearest;
  abi::MipFilter mip = abi::MipFilter::None;
  Path path = Path::OneToOne;
  abi::Layout layout = abi::Layout::U8x4;
  bool texels = false, packed = false;
  abi::Dimension dimension = abi::Dimension::Tex2D;
  abi::Lanes lanes = abi::Lanes::Row;
  abi::Wrap wrap = abi::Wrap::Repeat;
  float longer = 0; ///< anisotropic filter: ratio of the pixel footprint's length to its width; 0:
                    ///< no such filter
};

using abi::Filter;
using abi::Layout;
using abi::MipFilter;
const Bench kBenches[] = {
    {"consecutive-packed", Filter::Nearest, MipFilter::None, Path::OneToOne, Layout::U8x4, true,
     true},
    {"consecutive", Filter::Nearest, MipFilter::None, Path::OneToOne, Layout::U8x4, true},
    {"nearest-1:1-packed", Filter::Nearest, MipFilter::None, Path::OneToOne, Layout::U8x4, false,
     true},
    {"nearest-1:1", Filter::Nearest},
    {"nearest-magnified", Filter::Nearest, MipFilter::None, Path::Magnified},
    {"nearest-rotated", Filter::Nearest, MipFilter::None, Path::Rotated},
    {"nearest-scattered", Filter::Nearest, MipFilter::None, Path::Scattered},
    {"bilinear-1:1", Filter::Linear},
    {"bilinear-magnified", Filter::Linear, MipFilter::None, Path::Magnified},
    {"bilinear-rotated", Filter::Linear, MipFilter::None, Path::Rotated},
    {"bilinear-rotated-edge", Filter::Linear, MipFilter::None, Path::Rotated, Layout::U8x4, false,
     false, abi::Dimension::Tex2D, abi::Lanes::Row, abi::Wrap::ClampToEdge},
    {"bilinear-rotated-quad", Filter::Linear, MipFilter::None, Path::Rotated, Layout::U8x4, false,
     false, abi::Dimension::Tex2D, abi::Lanes::Quad},
    {"bilinear-scattered", Filter::Linear, MipFilter::None, Path::Scattered},
    {"bilinear-float-rotated", Filter::Linear, MipFilter::None, Path::Rotated, Layout::F32x4},
    {"trilinear-rotated", Filter::Linear, MipFilter::Linear, Path::Minified},
    {"trilinear-rotated-quad", Filter::Linear, MipFilter::Linear, Path::Minified, Layout::U8x4,
     false, false, abi::Dimension::Tex2D, abi::Lanes::Quad},
    {"anisotropic-1-rotated", Filter::Linear, MipFilter::Linear, Path::Minified, Layout::U8x4,
     false, false, abi::Dimension::Tex2D, abi::Lanes::Row, abi::Wrap::Repeat, 1},
    {"anisotropic-4-rotated", Filter::Linear, MipFilter::Linear, Path::Minified, Layout::U8x4,
     false, false, abi::Dimension::Tex2D, abi::Lanes::Row, abi::Wrap::Repeat, 4},
    {"anisotropic-16-rotated", Filter::Linear, MipFilter::Linear, Path::Minified, Layout::U8x4,
     false, false, abi::Dimension::Tex2D, abi::Lanes::Row, abi::Wrap::Repeat, 16},
    {"cube-nearest", Filter::Nearest, MipFilter::None, Path::Rotated, Layout::U8x4, false, false,
     abi::Dimension::Cube},
    {"cube-bilinear", Filter::Linear, MipFilter::None, Path::Rotated, Layout::U8x4, false, false,
     abi::Dimension::Cube},
};

abi::SamplerKey keyOf(const Bench &bench) {
  abi::SamplerKey key;
  key.dimension = bench.dimension;
  key.format.layout = bench.layout;
  key.magnify = key.minify = bench.filter;
  key.mip = bench.mip;
  key.wrap = {bench.wrap, bench.wrap, bench.wrap};
  key.powerOfTwo = 7;
  key.anisotropic = bench.longer > 0;
  return key;
}

SampleOptions optionsOf(const Bench &bench) {
  SampleOptions options;
  options.lanes = bench.lanes;
  options.derivatives = bench.mip != MipFilter::None && bench.lanes == abi::Lanes::Row;
  options.texels = bench.texels;
  options.onlyPacked = bench.packed;
  return options;
}

void run(benchmark::State &state, const Bench &bench, const char *cpuName) {
  const auto cpu = chooseCpu(cpuName);
  if (!cpu)
    return state.SkipWithError("this processor does not run it");
  std::string reason;
  const auto function = SampleFunction::make(*cpu, keyOf(bench), optionsOf(bench), reason);
  if (!function)
    return state.SkipWithError(reason.c_str());
  std::mt19937 random(1);
  GuardedTexture texture(keyOf(bench), {kSize, kSize, 1}, random);
  std::vector<float> coordinate[3], result[4];
  std::vector<std::uint32_t> packed(kPixels);
  SampleCall call;
  call.view = &texture.view;
  texture.view.maxAnisotropy = std::max(bench.longer, 1.0f);
  const float scale = bench.path == Path::Magnified  ? 0.3f
                      : bench.path == Path::Minified ? 2.5f
                                                     : 1;
  const float angle = bench.path == Path::OneToOne || bench.path == Path::Magnified ? 0 : 0.4f;
  const float dx[3] = {scale * std::cos(angle) / kSize, scale * std::sin(angle) / kSize, 0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < kPixels; ++i) {
      const float start = axis == 2 ? 1 : 0.5f / kSize;
      coordinate[axis].push_back(bench.path == Path::Scattered
                                     ? std::uniform_real_distribution<float>(0, 1)(random)
                                     : start + dx[axis] * float(i % kSize));
    }
    call.coordinate[axis] = coordinate[axis].data();
    call.dx[axis] = dx[axis];
    call.dy[axis] = dx[1 - axis % 2];
    if (bench.longer > 0) // at right angles
      call.dy[axis] = (axis == 0 ? -dx[1] : axis == 1 ? dx[0] : 0) * bench.longer;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    result[i].resize(kPixels);
    call.result[i] = result[i].data();
  }
  call.packed = packed.data();
  call.texels = texture.view.levels[0].base;
  const auto chunks = std::uint32_t(kPixels / cpu->lanes());
  double best = 1e9;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    (*function)(call, chunks);
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count());
    benchmark::ClobberMemory();
  }
  // This is the best of all calls, so that other programs on the machine do not count.
  state.counters["ns/pixel"] = best / kPixels;
}

} // namespace
} // namespace arbiter::fp::llvm_back::testing

int main(int argc, char **argv) {
  using namespace arbiter::fp::llvm_back;
  using namespace arbiter::fp::llvm_back::testing;
  const char *const wanted = std::getenv("SAMPLE_ASSEMBLY");
  for (const Bench &bench : kBenches) {
    if (wanted && bench.name == std::string(wanted)) {
      std::puts(SampleFunction::assembly(*chooseCpu(""), keyOf(bench), optionsOf(bench)).c_str());
      return 0;
    }
    for (const char *const cpu : {"", "avx512", "avx2", "sse4.1"})
      benchmark::RegisterBenchmark(
          (std::string(bench.name) + "/" + (*cpu ? cpu : "this")).c_str(),
          [&bench, cpu](benchmark::State &state) { run(state, bench, cpu); })
          ->MinTime(0.05);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
