#include "swrast/rasterize.h"
#include "swrast/setup/rectangle.h"

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

using testing::Canvas;
using testing::drawAll;
using testing::WindowVertices;

void addInput(Canvas &canvas, abi::Interpolation interpolation) {
  canvas.shading.inputCount = 1;
  canvas.shading.interpolation[0] = interpolation;
  canvas.shading.inputComponents[0] = 1;
}

TEST(Rasterize, AScreenQuadMapsTexelsToPixelsExactly) {
  for (const int size : {1, 2, 255, 1000, 1023, 1024, 4095, 4096}) {
    for (const Topology topology :
         {Topology::Quads, Topology::TriangleStrip, Topology::Triangles}) {
      Canvas canvas(size, 3);
      addInput(canvas, abi::Interpolation::Linear);
      WindowVertices vertices(canvas);
      const auto corner = [&](int which) {
        const bool right = which == 1 || which == 2;
        vertices.add(right ? size : 0, which >= 2 ? 3 : 0, right ? 1 : 0);
      };
      if (topology == Topology::Quads)
        for (const int i : {0, 1, 2, 3})
          corner(i);
      else if (topology == Topology::TriangleStrip)
        for (const int i : {0, 1, 3, 2})
          corner(i);
      else
        for (const int i : {0, 1, 2, 2, 3, 0})
          corner(i);
      const DrawStatistics statistics = drawAll(canvas, topology, vertices);
      EXPECT_EQ(statistics.primitives, 1u) << "one rectangle";
      EXPECT_EQ(statistics.pixels, std::uint64_t(size) * 3);
      for (int y = 0; y < 3; ++y)
        for (int x = 0; x < size; ++x) {
          ASSERT_EQ(canvas.at(x, y), 1u);
          ASSERT_NEAR(double(canvas.valueAt(x, y)) * size - x, 0.5, 1.0 / 1024)
              << x << " of " << size;
        }
      EXPECT_EQ(surelyCovered(canvas.state, topology, vertices.get(), nullptr, 0,
                              std::uint32_t(vertices.inputs.size())),
                (Rect{0, 0, size, 3}));
    }
  }
}

TEST(Rasterize, WhatIsNotAffineIsTwoTriangles) {
  Canvas canvas(64, 64);
  addInput(canvas, abi::Interpolation::Linear);
  WindowVertices vertices(canvas);
  vertices.add(0, 0, 0);
  vertices.add(64, 0, 0);
  vertices.add(64, 64, 0);
  vertices.add(0, 64, 1);
  EXPECT_EQ(drawAll(canvas, Topology::Quads, vertices).primitives, 2u);
  for (const std::uint32_t count : canvas.counts)
    ASSERT_EQ(count, 1u);
  // The diagonal runs from the first vertex to the third.
  EXPECT_FLOAT_EQ(canvas.valueAt(0, 40), 40.0f / 64);
  EXPECT_NEAR(canvas.valueAt(60, 20), 0, 1e-6);
}

/// A function of the object's plane, seen in perspective, is found again at every pixel.
TEST(Rasterize, InputsAreThePlanesValues) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> at(-20, 120), depth(0.5, 8), value(-3, 3);
  for (int round = 0; round < 300; ++round) {
    Canvas canvas(100, 100);
    addInput(canvas, abi::Interpolation::Perspective);
    canvas.state.upsideDownHeight = round % 2 ? 100 : 0;
    if (round % 3 == 0)
      canvas.useQuads(16);
    WindowVertices vertices(canvas);
    double px[3], py[3], w[3], f[3];
    for (int k = 0; k < 3; ++k) {
      px[k] = at(random);
      py[k] = at(random);
      w[k] = round % 4 ? depth(random) : 2.0;
      f[k] = value(random);
      vertices.add(px[k], py[k], float(f[k]), float(w[k]));
    }
    const double area = (px[1] - px[0]) * (py[2] - py[0]) - (px[2] - px[0]) * (py[1] - py[0]);
    if (std::fabs(area) < 200)
      continue;
    (void)drawAll(canvas, Topology::Triangles, vertices);
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 100; ++x) {
        if (canvas.at(x, y) == 0)
          continue;
        const double cx = x + 0.5, cy = y + 0.5;
        double overW = 0;
        for (int k = 0; k < 3; ++k) {
          const int a = (k + 1) % 3, b = (k + 2) % 3;
          const double share =
              ((px[b] - px[a]) * (cy - py[a]) - (py[b] - py[a]) * (cx - px[a])) / area;
          overW += share * f[k] / w[k];
        }
        // What is shaded is the value over w; clipping may not change it.
        ASSERT_NEAR(canvas.valueAt(x, y), overW, 3e-5) << x << ", " << y << " round " << round;
      }
  }
}

/// The first vertex provokes, of quads only where the convention holds for quads too
/// (QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION). All of the paths that a quad may take agree.
/// A draw of so many triangles, or of one rectangle, to all of the canvas or to a part.
void drawValues(Canvas &canvas, std::uint32_t seed, int triangles, const Rect &scissor) {
  addInput(canvas, abi::Interpolation::Linear);
  canvas.state.clip = scissor;
  std::mt19937 random(seed);
  // Beyond the canvas too, and some of them small.
  std::uniform_real_distribution<double> at(-120, 360), beside(-9, 9), value(-3, 3);
  WindowVertices vertices(canvas);
  if (triangles == 0) {
    const double left = at(random), bottom = at(random), right = at(random), top = at(random);
    for (const auto &[x, y] : {std::pair{left, bottom}, {right, bottom}, {right, top}, {left, top}})
      vertices.add(x, y, float(x * 0.37 + y * 0.11));
    drawAll(canvas, Topology::Quads, vertices);
    return;
  }
  for (int i = 0; i < triangles; ++i) {
    const double x = at(random), y = at(random);
    const bool small = i % 2 == 1;
    for (int k = 0; k < 3; ++k)
      vertices.add(small ? x + beside(random) : at(random), small ? y + beside(random) : at(random),
                   float(value(random)));
  }
  drawAll(canvas, Topology::Triangles, vertices);
}

/// OpenGL 2.1, appendix A, rule 2: a change of the scissor box has no side effects. Applications
/// draw the depths of a scene first, and then each light's part of it with GL_EQUAL.
TEST(Rasterize, AScissorChangesNoValueOfWhatItLeaves) {
  for (const int lanes : {0, 4, 8, 16})
    for (const int triangles : {0, 1, 3, 40})
      for (std::uint32_t seed = 0; seed < 12; ++seed) {
        const auto make = [&](const Rect &scissor) {
          auto canvas = std::make_unique<Canvas>(240, 240);
          if (lanes != 0)
            canvas->useQuads(lanes);
          drawValues(*canvas, seed, triangles, scissor);
          return canvas;
        };
        const auto whole = make({0, 0, 240, 240});
        for (const Rect &part : {Rect{7, 3, 2, 2}, Rect{65, 130, 100, 70}, Rect{0, 201, 240, 1}}) {
          const auto cut = make(part);
          for (int y = part.y; y < part.y + part.height; ++y)
            for (int x = part.x; x < part.x + part.width; ++x) {
              ASSERT_EQ(cut->at(x, y), whole->at(x, y)) << x << ' ' << y;
              ASSERT_EQ(cut->valueAt(x, y), whole->valueAt(x, y))
                  << x << ' ' << y << " of " << triangles << ", seed " << seed;
            }
        }
      }
}

TEST(Rasterize, FlatInputsAreTheProvokingVertexs) {
  struct Case {
    Topology topology;
    float last, first, firstButOfQuads;
  };
  for (const Case &expected : {Case{Topology::Quads, 4, 1, 4}, Case{Topology::QuadStrip, 3, 1, 3},
                               Case{Topology::Triangles, 3, 1, 1}, Case{Topology::Polygon, 1, 1, 1},
                               Case{Topology::TriangleFan, 3, 2, 2}}) {
    for (const bool first : {false, true})
      for (const bool quadsToo : {false, true})
        for (const double lean : {0.0, 0.25}) { // upright, and none that is one rectangle
          Canvas canvas(32, 32);
          addInput(canvas, abi::Interpolation::Flat);
          canvas.state.provokingIsFirst = first;
          canvas.state.quadsProvokingIsFirst = first && quadsToo;
          WindowVertices vertices(canvas);
          const bool strip = expected.topology == Topology::QuadStrip;
          vertices.add(lean, 0, 1);
          vertices.add(32, lean, 2);
          vertices.add(strip ? 0 : 32 - lean, 32, strip ? 4 : 3);
          vertices.add(strip ? 32 - lean : 0, 32 - lean, strip ? 3 : 4);
          drawAll(canvas, expected.topology, vertices);
          EXPECT_EQ(canvas.valueAt(30, 3), !first     ? expected.last
                                           : quadsToo ? expected.first
                                                      : expected.firstButOfQuads)
              << int(expected.topology) << (lean != 0 ? " leaning" : "");
        }
  }
}

TEST(Rasterize, BackFacesTakeTheirOwnInputs) {
  for (const bool clockwise : {false, true}) {
    Canvas canvas(16, 16);
    addInput(canvas, abi::Interpolation::Linear);
    canvas.state.frontIsClockwise = clockwise;
    WindowVertices vertices(canvas);
    vertices.add(0, 0, 1);
    vertices.add(16, 0, 1);
    vertices.add(0, 16, 1);
    const float back[3] = {7, 7, 7};
    Vertices arrays = vertices.get();
    arrays.backInputs[0][0] = back;
    rasterize(canvas.state, canvas.shading, Topology::Triangles, arrays, nullptr, 0, 3);
    EXPECT_EQ(canvas.valueAt(2, 2), clockwise ? 7 : 1);
  }
}

/// A draw of everything at once, on so many threads.
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
        values = canvas.values; // of the last triangle on each pixel: the order is kept
      }
      EXPECT_EQ(counts, canvas.counts) << threads << " threads";
      EXPECT_EQ(values, canvas.values) << threads << " threads";
    }
  }
  setThreadCount(0);
}

TEST(Rasterize, WhatAnOpaqueTriangleHidesIsNotDrawn) {
  Canvas canvas(256, 256);
  addInput(canvas, abi::Interpolation::Linear);
  canvas.shading.opaque = true;
  WindowVertices vertices(canvas);
  for (int i = 0; i < 60; ++i) {
    vertices.add(10, 10, 1);
    vertices.add(200, 10, 1);
    vertices.add(10, 200, 1);
  }
  vertices.add(-10, -10, 2);
  vertices.add(600, -10, 2);
  vertices.add(-10, 600, 2);
  vertices.add(100, 100, 3);
  vertices.add(120, 100, 3);
  vertices.add(100, 120, 3);
  drawAll(canvas, Topology::Triangles, vertices);
  EXPECT_EQ(canvas.at(20, 20), 1u);
  EXPECT_EQ(canvas.valueAt(20, 20), 2);
  EXPECT_EQ(canvas.at(104, 104), 2u);
  EXPECT_EQ(canvas.valueAt(104, 104), 3);
}

TEST(Rasterize, SurelyCoveredIsOnlyWhatIsSure) {
  Canvas canvas(64, 64);
  WindowVertices quad(canvas);
  quad.add(-5, 3.2);
  quad.add(40.5, 3.2);
  quad.add(40.5, 80);
  quad.add(-5, 80);
  const auto covered = [&](const RasterState &state) {
    return surelyCovered(state, Topology::Quads, quad.get(), nullptr, 0, 4);
  };
  EXPECT_EQ(covered(canvas.state), (Rect{0, 3, 40, 61}));
  drawAll(canvas, Topology::Quads, quad);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      ASSERT_EQ(canvas.at(x, y), x < 40 && y >= 3 ? 1u : 0u) << x << ", " << y;
  RasterState state = canvas.state;
  state.clip = {10, 10, 5, 5};
  EXPECT_EQ(covered(state), (Rect{10, 10, 5, 5}));
  state = canvas.state;
  state.cullFront = true;
  EXPECT_TRUE(covered(state).empty());
  state = canvas.state;
  state.front = PolygonMode::Line;
  EXPECT_TRUE(covered(state).empty());
  state = canvas.state;
  const std::uint8_t stipple[128] = {};
  state.polygonStipple = stipple;
  EXPECT_TRUE(covered(state).empty());
  quad.position[0][2] += 0.2f;
  EXPECT_TRUE(covered(canvas.state).empty()) << "crooked";
}

TEST(Rasterize, AffineIsWhereAllWAreEqual) {
  Canvas canvas(8, 8);
  WindowVertices vertices(canvas);
  for (int i = 0; i < 4; ++i)
    vertices.add(i, i, 0, 2);
  EXPECT_TRUE(isAffine(vertices.get()));
  vertices.add(1, 1, 0, 2.0000002f);
  EXPECT_FALSE(isAffine(vertices.get()));
}

TEST(Rasterize, NothingIsWrittenOutsideWhateverTheVertices) {
  std::mt19937 random(13);
  const float odd[] = {0,        -0.0f,     1,   -1,   1e-38f, 1e38f,  -1e38f,
                       INFINITY, -INFINITY, NAN, 0.5f, -0.5f,  1e-45f, 65536};
  std::uniform_int_distribution<int> pick(0, int(std::size(odd)) - 1);
  for (int round = 0; round < 3000; ++round) {
    Canvas canvas(40, 40);
    if (round % 2)
      canvas.useQuads(16);
    addInput(canvas, abi::Interpolation::Perspective);
    canvas.state.clip = {5, 6, 20, 21};
    canvas.state.depthClamp = round % 3 == 0;
    canvas.state.front = PolygonMode(round % 5 % 3);
    canvas.state.pointSize = odd[pick(random)];
    canvas.state.lineWidth = std::fabs(odd[pick(random)]);
    canvas.state.lineStippleFactor = round % 7 == 0 ? 3 : 0;
    WindowVertices vertices(canvas);
    for (int i = 0; i < 120; ++i) {
      for (std::vector<float> &component : vertices.position)
        component.push_back(odd[pick(random)]);
      vertices.inputs.push_back(odd[pick(random)]);
    }
    drawAll(canvas, Topology(round % 10), vertices);
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        const bool inside = x >= 5 && y >= 6 && x < 25 && y < 27;
        ASSERT_TRUE(inside || canvas.at(x, y) == 0) << x << ", " << y;
      }
  }
}

TEST(Rasterize, IndicesBeyondTheVerticesAreNotDrawn) {
  Canvas canvas(16, 16);
  WindowVertices vertices(canvas);
  vertices.add(0, 0);
  vertices.add(16, 0);
  vertices.add(16, 16);
  vertices.add(0, 16);
  const std::uint32_t indices[] = {0, 1, 2, 0, 2, 4000000000u, 0, 2, 3};
  const DrawStatistics statistics =
      rasterize(canvas.state, canvas.shading, Topology::Triangles, vertices.get(), indices, 0, 9);
  EXPECT_EQ(statistics.primitives, 2u);
  for (const std::uint32_t count : canvas.counts)
    ASSERT_EQ(count, 1u);
}

/// Vertices that are made as the draw comes to them: arrays of nothing until then.
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

/// Of triangles of all sizes, most of them without a pixel's centre: those that are sorted into
/// tiles are the same that are drawn one by one.
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
      // Corners between pixels and at their centres.
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
      // Quads of a draw that leaves the window are cut along their other diagonal.
      const TriangleCorners corners = triangleAt(topology, kCount, i, false, true);
      (void)rasterize(each.state, each.shading, Topology::Triangles, whole, corners.corner, 0, 3);
    }
    EXPECT_EQ(many.counts, each.counts) << "topology " << int(topology);
  }
}

} // namespace
} // namespace arbiter::swrast
