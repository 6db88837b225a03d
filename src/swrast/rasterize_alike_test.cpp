// Compares ways to draw that must give the same pixels: with more threads, with vertices filled
// late, with triangles drawn one by one.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "swrast/setup/assembly.h"
#include "swrast/testing/canvas.h"
#include "swrast/threads.h"

namespace arbiter::swrast {
namespace {

using testing::addInput;
using testing::Canvas;
using testing::drawAll;
using testing::WindowVertices;

/// Draws large and small primitives in one draw, with the given number of threads.
void drawMixture(Canvas &canvas) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(-40, 340), small(-6, 6);
  WindowVertices vertices(canvas);
  for (int i = 0; i < 600; ++i) {
    const double x = at(random), y = at(random);
    for (int k = 0; k < 3; ++k) {
      if (i % 50 == 0)
        vertices.add(at(random), at(random), float(i + k));
      else
        vertices.add(x + small(random), y + small(random), float(i + k));
    }
  }
  for (const Topology topology :
       {Topology::Triangles, Topology::Lines, Topology::Points, Topology::TriangleFan})
    drawAll(canvas, topology, vertices);
}

TEST(Rasterize, ThreadsDrawTheSamePicture) {
  for (const bool quads : {false, true}) {
    std::vector<std::uint32_t> counts;
    std::vector<float> values;
    for (const int threads : {1, 2, 4}) {
      setThreadCount(threads);
      Canvas canvas(300, 300);
      addInput(canvas, abi::Interpolation::Linear);
      if (quads)
        canvas.useQuads(16);
      drawMixture(canvas);
      if (counts.empty()) {
        counts = canvas.counts;
        // a pixel has the last triangle's value, so this checks the order too
        values = canvas.values;
      }
      EXPECT_EQ(counts, canvas.counts) << threads << " threads";
      EXPECT_EQ(values, canvas.values) << threads << " threads";
    }
  }
  setThreadCount(0);
}

/// Vertices whose arrays hold no values until the rasterizer asks for them.
struct MadeVertices {
  explicit MadeVertices(const Vertices &whole) : from(whole), vertices(whole) {
    for (int c = 0; c < 4; ++c) {
      position[c].assign(whole.count, std::nanf(""));
      vertices.position[c] = position[c].data();
    }
    input.assign(whole.count, std::nanf(""));
    vertices.inputs[0][0] = input.data();
    vertices.maker = this;
    vertices.make = [](const void *maker, std::uint32_t begin, std::uint32_t end) {
      static_cast<MadeVertices *>(const_cast<void *>(maker))->make(begin, end);
    };
  }
  MadeVertices(const MadeVertices &) = delete;
  MadeVertices &operator=(const MadeVertices &) = delete;

  void make(std::uint32_t begin, std::uint32_t end) {
    made += end - begin;
    for (int c = 0; c < 4; ++c)
      std::copy(from.position[c] + begin, from.position[c] + end, &position[c][begin]);
    std::copy(from.inputs[0][0] + begin, from.inputs[0][0] + end, &input[begin]);
  }
  Vertices from, vertices;
  std::vector<float> position[4], input;
  std::atomic<std::uint32_t> made{0};
};

TEST(Rasterize, VerticesMayBeMadeAsTheDrawComesToThem) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(-20, 120), near(-3, 3), value(-3, 3);
  for (const Topology topology :
       {Topology::Points, Topology::Lines, Topology::LineStrip, Topology::Triangles,
        Topology::TriangleStrip, Topology::Quads, Topology::QuadStrip, Topology::TriangleFan}) {
    const std::uint32_t count = 5 * Vertices::kStretch + 7;
    Canvas canvas(100, 100), other(100, 100);
    WindowVertices whole(canvas);
    double x = 50, y = 50;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (i % 12 == 0)
        x = at(random), y = at(random);
      whole.add(x + near(random), y + near(random), value(random));
    }
    for (Canvas *const each : {&canvas, &other}) {
      addInput(*each, abi::Interpolation::Linear);
      each->useQuads(16);
      each->state.cullBack = true;
    }
    MadeVertices made(whole.get());
    (void)rasterize(canvas.state, canvas.shading, topology, whole.get(), nullptr, 0, count);
    (void)rasterize(other.state, other.shading, topology, made.vertices, nullptr, 0, count);
    EXPECT_EQ(made.made.load(), count);
    EXPECT_EQ(canvas.counts, other.counts);
    EXPECT_EQ(canvas.values, other.values);
  }
}

/// Draws triangles of all sizes, most of which cover no pixel centre. Sorting them into tiles must
/// give the pixels of drawing them one by one.
TEST(Rasterize, ManyTrianglesAreThoseOfEach) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> at(-10, 74);
  constexpr double kSizes[] = {0.0, 0.05, 0.4, 1.5, 30};
  for (const Topology topology : {Topology::Triangles, Topology::TriangleStrip, Topology::Quads,
                                  Topology::QuadStrip, Topology::TriangleFan, Topology::Polygon}) {
    Canvas many(64, 64), each(64, 64);
    WindowVertices vertices(many);
    constexpr std::uint32_t kCount = 600;
    double x = 0, y = 0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const double size = kSizes[i / 12 % 5];
      if (i % 12 == 0)
        x = at(random), y = at(random);
      std::uniform_real_distribution<double> near(-size, size);
      // Corners lie between pixel centres, and on them.
      const double dx = near(random), dy = near(random);
      vertices.add(i % 7 == 0 ? std::floor(x) + 0.5 : x + dx, y + dy, 0);
    }
    for (Canvas *const canvas : {&many, &each}) {
      canvas->useQuads(16);
      canvas->state.cullFront = true;
    }
    const Vertices whole = vertices.get();
    (void)rasterize(many.state, many.shading, topology, whole, nullptr, 0, kCount);
    const std::uint32_t triangles = triangleCount(topology, kCount);
    ASSERT_GT(triangles, 32u) << "few are not sorted";
    for (std::uint32_t i = 0; i < triangles; ++i) {
      // Quads of a draw that leaves the window are split along their other diagonal.
      const TriangleCorners corners = triangleAt(topology, kCount, i, false, true);
      (void)rasterize(each.state, each.shading, Topology::Triangles, whole, corners.corner, 0, 3);
    }
    EXPECT_EQ(many.counts, each.counts) << "topology " << int(topology);
  }
}

} // namespace
} // namespace arbiter::swrast
