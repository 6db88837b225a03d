#include <cmath>
#include <cstring>

#include <benchmark/benchmark.h>

#include "swrast/testing/canvas.h"
#include "swrast/threads.h"

/// Measures the rasterizer's speed with shading functions that do little.
namespace arbiter::swrast {
namespace {

using testing::Canvas;
using testing::WindowVertices;

void fillRow(const abi::FragmentData *data, const abi::Primitive *, const void *items,
             std::uint32_t count) {
  const auto *const spans = static_cast<const abi::Span *>(items);
  for (std::uint32_t i = 0; i < count; ++i)
    std::memset(data->targets[0].base + spans[i].y * data->targets[0].rowStride + spans[i].x * 4,
                0x55, std::size_t(spans[i].count) * 4);
}

/// A shading function with enough arithmetic not to be bound by memory.
void workRow(const abi::FragmentData *data, const abi::Primitive *primitive, const void *items,
             std::uint32_t count) {
  const auto *const spans = static_cast<const abi::Span *>(items);
  for (std::uint32_t i = 0; i < count; ++i) {
    auto *const row = reinterpret_cast<std::uint32_t *>(data->targets[0].base +
                                                        spans[i].y * data->targets[0].rowStride);
    for (int x = spans[i].x; x < spans[i].x + spans[i].count; ++x) {
      float value = float(x) * primitive->inputs[0][0].dx;
      for (int k = 0; k < 8; ++k)
        value = value * value + 0.25f;
      row[x] = std::uint32_t(value);
    }
  }
}

void fillBlocks(const abi::FragmentData *data, const abi::Primitive *primitive, const void *items,
                std::uint32_t count) {
  const auto *const blocks = static_cast<const abi::Block *>(items);
  for (std::uint32_t i = 0; i < count; ++i) {
    auto *const pixel = reinterpret_cast<std::uint32_t *>(
        data->targets[0].base + blocks[i].y * data->targets[0].rowStride + blocks[i].x * 4);
    *pixel = std::uint32_t(blocks[i].mask) + std::uint32_t(primitive->inputs[0][0].dx);
  }
}

/// Arguments: width and height (one value), and threads.
template <abi::ShadeFunction kRow> void screenQuad(benchmark::State &bench) {
  const int size = int(bench.range(0));
  setThreadCount(int(bench.range(1)));
  Canvas canvas(size, size);
  canvas.shading.row = kRow;
  canvas.shading.inputCount = 1;
  canvas.shading.interpolation[0] = abi::Interpolation::Linear;
  canvas.shading.inputComponents[0] = 3;
  WindowVertices vertices(canvas);
  vertices.add(0, 0, 0);
  vertices.add(size, 0, 1);
  vertices.add(size, size, 1);
  vertices.add(0, size, 0);
  for (auto _ : bench)
    drawAll(canvas, Topology::Quads, vertices);
  bench.SetItemsProcessed(bench.iterations() * std::int64_t(size) * size);
  setThreadCount(0);
}
BENCHMARK(screenQuad<fillRow>)->ArgsProduct({{16, 256, 1024, 4096}, {1, 2}})->UseRealTime();
BENCHMARK(screenQuad<workRow>)->ArgsProduct({{256, 1024, 4096}, {1, 2}})->UseRealTime();

/// Draws a grid of triangles, in layers, with sides of about `range(0)` pixels and inputs of 8
/// components.
void triangles(benchmark::State &bench) {
  constexpr int kSize = 1024;
  setThreadCount(int(bench.range(2)));
  const int side = int(bench.range(0)), wanted = int(bench.range(1));
  Canvas canvas(kSize, kSize);
  canvas.useQuads(16);
  canvas.shading.quad = fillBlocks;
  canvas.shading.inputCount = 2;
  for (int i = 0; i < 2; ++i) {
    canvas.shading.interpolation[i] = abi::Interpolation::Perspective;
    canvas.shading.inputComponents[i] = 0xF;
  }
  WindowVertices vertices(canvas);
  const int columns = kSize / side;
  for (int i = 0; i < wanted; ++i) {
    const double x = i % columns * side + 0.3, y = i / columns % columns * side + 0.7;
    vertices.add(x, y, 1, 1);
    vertices.add(x + side, y, 2, 1.5f);
    vertices.add(x, y + side, 3, 1.25f);
  }
  Vertices arrays = vertices.get();
  for (int i = 0; i < 2; ++i)
    for (int c = 0; c < 4; ++c)
      arrays.inputs[i][c] = vertices.inputs.data();
  for (auto _ : bench)
    rasterize(canvas.state, canvas.shading, Topology::Triangles, arrays, nullptr, 0, arrays.count);
  bench.SetItemsProcessed(bench.iterations() * wanted);
  setThreadCount(0);
}
BENCHMARK(triangles)
    ->ArgsProduct({{2, 5, 20}, {100000}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void emptyJob(benchmark::State &bench) {
  setThreadCount(int(bench.range(0)));
  auto work = [](std::uint32_t i) { benchmark::DoNotOptimize(i); };
  for (auto _ : bench)
    parallel(8, work);
  setThreadCount(0);
}
BENCHMARK(emptyJob)->Arg(1)->Arg(2)->UseRealTime();

} // namespace
} // namespace arbiter::swrast

BENCHMARK_MAIN();
