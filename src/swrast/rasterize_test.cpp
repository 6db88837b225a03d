#include "swrast/rasterize.h"
#include "swrast/setup/rectangle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "swrast/testing/canvas.h"

namespace arbiter::swrast {
namespace {

using testing::addInput;
using testing::Canvas;
using testing::drawAll;
using testing::WindowVertices;

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
      // The two triangles' planes begin at different corners. They are equal if nothing is rounded.
      if (topology != Topology::Triangles || (size & (size - 1)) == 0) {
        EXPECT_EQ(statistics.primitives, 1u) << "one rectangle";
      }
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

/// A linear function on a plane, seen in perspective, must have its value at every pixel.
TEST(Rasterize, InputsAreThePlanesValues) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> at(-20, 120), depth(0.5, 8), value(-3, 3);
  for (int round = 0; round < 300; ++round) {
    Canvas canvas(100, 100);
    addInput(canvas, abi::Interpolation::Perspective);
    canvas.turn(round % 2 != 0);
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
        // The shaded value is f/w; clipping must not change it.
        ASSERT_NEAR(canvas.valueAt(x, y), overW, 3e-5) << x << ", " << y << " round " << round;
      }
  }
}

/// The first vertex provokes, for quads only if QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION holds. All
/// code paths that may draw a quad must agree.
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
        for (const double lean : {0.0, 0.25}) { // an upright quad, and one that is no rectangle
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

TEST(Rasterize, InputsAreLinearWhereAllWAreOnePowerOfTwo) {
  const auto how = [](float w, float last) {
    Canvas canvas(8, 8);
    WindowVertices vertices(canvas);
    for (int i = 0; i < 4; ++i)
      vertices.add(i, i, 0, double(w));
    vertices.add(1, 1, 0, double(last));
    return interpolationOf(vertices.get());
  };
  for (const float w : {1.0f, 0.125f, 4.0f})
    EXPECT_EQ(how(w, w), abi::Interpolation::Linear) << w;
  for (const float w : {3.0f, 0.3f, 1.0000001f})
    EXPECT_EQ(how(w, w), abi::Interpolation::Even) << w;
  EXPECT_EQ(how(2, 2.0000002f), abi::Interpolation::Perspective);
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

} // namespace
} // namespace arbiter::swrast
