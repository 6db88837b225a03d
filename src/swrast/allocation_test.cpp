#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

#include "swrast/image/image.h"
#include "swrast/queue/draw_queue.h"
#include "swrast/testing/canvas.h"
#include "swrast/threads.h"

/// Checks that repeated draws, and a feedback loop between two images, do not allocate from the
/// heap.
namespace {
std::atomic<std::uint64_t> g_allocations{0};
/// countdown: the allocation that brings it to 0 fails; 0: no failure is planned
std::atomic<int> g_untilFailure{0};
} // namespace
// Not inlined: if only one of new and delete is inlined, the compiler reports a mismatched pair.
[[gnu::noinline]] void *operator new(std::size_t size) {
  g_allocations.fetch_add(1, std::memory_order_relaxed);
  if (g_untilFailure.load(std::memory_order_relaxed) != 0 && --g_untilFailure == 0)
    throw std::bad_alloc();
  if (void *const memory = std::malloc(size ? size : 1))
    return memory;
  throw std::bad_alloc();
}
// A sanitizer's nothrow operator new does not call the operator above, so this one is replaced too.
[[gnu::noinline]] void *operator new(std::size_t size, const std::nothrow_t &) noexcept {
  g_allocations.fetch_add(1, std::memory_order_relaxed);
  return std::malloc(size ? size : 1);
}
[[gnu::noinline]] void operator delete(void *memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void *memory, std::size_t) noexcept { std::free(memory); }

namespace arbiter::swrast {
namespace {

using testing::Canvas;
using testing::drawAll;
using testing::WindowVertices;

class Allocation : public ::testing::TestWithParam<int> {
protected:
  void SetUp() override { setThreadCount(GetParam()); }
  void TearDown() override { setThreadCount(0); }
};

TEST_P(Allocation, DrawsLikeTheLastTakeNone) {
  for (const Topology topology : {Topology::Points, Topology::LineStrip, Topology::Triangles,
                                  Topology::TriangleStrip, Topology::Quads, Topology::Polygon})
    for (const int count : {4, 6, 60, 9000}) {
      Canvas canvas(200, 200);
      canvas.useQuads(16);
      canvas.state.clip = {80, 80, 24, 24};
      WindowVertices vertices(canvas);
      for (int i = 0; i < count; ++i)
        vertices.add(i * 37 % 251 - 20, i * 91 % 241 - 20);
      for (int warm = 0; warm < 3; ++warm)
        drawAll(canvas, topology, vertices);
      const std::uint64_t before = g_allocations.load();
      const DrawStatistics statistics = drawAll(canvas, topology, vertices);
      EXPECT_EQ(g_allocations.load(), before) << int(topology) << " of " << count;
      // A few vertices may miss the clip rectangle, which this test keeps small.
      EXPECT_TRUE(count < 1000 || statistics.pixels > 0) << int(topology);
    }
}

TEST_P(Allocation, FramesOfDrawsThatWaitTakeNone) {
  Canvas canvas(200, 200);
  canvas.useQuads(16);
  canvas.state.clip = {80, 80, 24, 24}; // keeps the draws small
  Image target = makeImage({abi::Layout::U8x4, abi::kRgba}, 200, 200);
  Storage *const storages[] = {target.storage.get()};
  ShadingUse use;
  use.targets = storages;
  DrawQueue queue;
  std::uint64_t before = 0;
  for (int frame = 0; frame < 12; ++frame) {
    if (frame == 6)
      before = g_allocations.load();
    for (const int count : {4, 60, 3000, 12}) {
      canvas.data.alphaReference = float(count); // makes the state differ from the last draw's
      WindowVertices vertices(canvas);
      {
        const std::uint64_t outside = g_allocations.load();
        for (int i = 0; i < count; ++i)
          vertices.add(i * 37 % 251 - (count < 3000 ? 20 : 0), i * 91 % 200, 0);
        before += g_allocations.load() - outside;
      }
      for (const Topology topology : {Topology::Triangles, Topology::LineStrip, Topology::Points})
        if (count != 3000 || topology == Topology::Triangles) {
          ASSERT_TRUE(queue.add(canvas.state, canvas.shading, topology, vertices.get(), nullptr, 0,
                                std::uint32_t(count), use));
        }
    }
    (void)target.pixel(0, 0);
    ASSERT_TRUE(queue.isEmpty());
  }
  EXPECT_EQ(g_allocations.load(), before);
}

TEST_P(Allocation, WhatIsJoinedIsDrawnWhereMemoryRunsOut) {
  int failed = 0;
  for (int at = 1; at < 12; ++at) {
    Canvas canvas(200, 200);
    DrawQueue queue;
    for (int y = 10; y < 180; y += 20)
      for (int x = 10; x < 180; x += 20) {
        WindowVertices vertices(canvas);
        vertices.add(x, y);
        vertices.add(x + 10.5, y + 1);
        vertices.add(x, y + 10);
        ASSERT_TRUE(queue.add(canvas.state, canvas.shading, Topology::Triangles, vertices.get(),
                              nullptr, 0, 3, ShadingUse()));
      }
    g_untilFailure = at;
    queue.finish();
    failed += g_untilFailure == 0 ? 1 : 0;
    g_untilFailure = 0;
    for (int y = 10; y < 180; y += 20)
      for (int x = 10; x < 180; x += 20)
        ASSERT_EQ(canvas.at(x + 2, y + 3), 1u) << x << ", " << y << ", allocation " << at;
  }
  EXPECT_GT(failed, 3);
}

// Draws of every kind, more than the queue joins at a time, are mixed with other draws of the same
// state. Whichever allocation of the queue fails, each draw must appear, with the input of its own
// provoking vertex.
TEST_P(Allocation, DrawsAfterWhatMemoryRanOutForAreDrawn) {
  constexpr Topology kTopologies[] = {Topology::Triangles, Topology::TriangleFan, Topology::Quads,
                                      Topology::Polygon};
  const auto drawn = [&](int failAt, bool &failed) {
    Canvas canvas(200, 200);
    addInput(canvas, abi::Interpolation::Flat);
    canvas.state.flatShade = true;
    std::vector<WindowVertices> meshes;
    for (int i = 0; i < 900; ++i) {
      const int x = i % 30 * 6 + 3, y = i / 30 * 6 + 3;
      WindowVertices &vertices = meshes.emplace_back(canvas);
      vertices.add(x, y, float(i));
      vertices.add(x + 5, y + 1, float(i) + 0.25f);
      vertices.add(x + 4, y + 5, float(i) + 0.5f);
      vertices.add(x, y + 4, float(i) + 0.75f);
    }
    DrawQueue queue;
    g_untilFailure = failAt;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const bool isLine = i % 350 == 349;
      const Topology topology = isLine ? Topology::Lines : kTopologies[i % 4];
      const std::uint32_t count = isLine ? 2 : topology == Topology::Triangles ? 3 : 4;
      const Vertices vertices = meshes[i].get();
      if (queue.add(canvas.state, canvas.shading, topology, vertices, nullptr, 0, count,
                    ShadingUse()))
        continue;
      queue.finish();
      EXPECT_FALSE(rasterize(canvas.state, canvas.shading, topology, vertices, nullptr, 0, count)
                       .incomplete);
    }
    queue.finish();
    failed = failAt != 0 && g_untilFailure == 0;
    g_untilFailure = 0;
    return std::pair(canvas.counts, canvas.values);
  };
  bool failed = false;
  const auto whole = drawn(0, failed);
  int at = 0;
  do {
    ASSERT_EQ(drawn(++at, failed), whole) << "allocation " << at;
  } while (failed);
  EXPECT_GT(at, 10);
}

TEST_P(Allocation, FeedbackBetweenTwoImagesTakesNone) {
  Image target = makeImage({abi::Layout::U8x4, abi::kRgba}, 640, 480), texture = target;
  std::uint64_t before = 0;
  for (int frame = 0; frame < 20; ++frame) {
    if (frame == 5)
      before = g_allocations.load();
    ASSERT_TRUE(makeWritable(target, frame % 2 != 0));
    texture = target;
  }
  EXPECT_EQ(g_allocations.load(), before);
}

INSTANTIATE_TEST_SUITE_P(Threads, Allocation, ::testing::Values(1, 2));

} // namespace
} // namespace arbiter::swrast
