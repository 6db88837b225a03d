#include "swrast/rasterize.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "swrast/canvas_testing.h"
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

/// A mesh with crooked corners, on and off pixel centres, and its whole border outside the canvas.
void drawMesh(Canvas &canvas, std::mt19937 &random, int cells, bool snapToCentres) {
  std::vector<std::pair<double, double>> points;
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  const double cellX = (canvas.width + 20.0) / cells, cellY = (canvas.height + 20.0) / cells;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x) {
      const bool border = x == 0 || y == 0 || x == cells || y == cells;
      double px = -10 + (x + (border ? 0 : shift(random))) * cellX;
      double py = -10 + (y + (border ? 0 : shift(random))) * cellY;
      if (snapToCentres) {
        px = std::floor(px) + 0.5;
        py = std::floor(py) + 0.5;
      }
      points.emplace_back(px, py);
    }
  WindowVertices vertices(canvas);
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const int at = y * (cells + 1) + x;
      const int a = at, b = at + 1, c = at + cells + 2, d = at + cells + 1;
      std::vector<int> order =
          (x + y) & 1 ? std::vector<int>{a, b, c, a, c, d} : std::vector<int>{b, a, d, c, b, d};
      for (const int i : order)
        vertices.add(points[std::size_t(i)].first, points[std::size_t(i)].second);
    }
  drawAll(canvas, Topology::Triangles, vertices);
}

TEST(Rasterize, MeshesCoverEachPixelOnce) {
  std::mt19937 random(1);
  for (int round = 0; round < 60; ++round) {
    Canvas canvas(97, 61);
    if (round % 4 != 0)
      canvas.useQuads(2 << (round % 4));
    drawMesh(canvas, random, round % 2 ? 3 + round % 6 : 3 + round % 17, round % 2 != 0);
    for (int y = 0; y < canvas.height; ++y)
      for (int x = 0; x < canvas.width; ++x)
        ASSERT_EQ(canvas.at(x, y), 1u) << x << ", " << y << " in round " << round;
  }
}

} // namespace
} // namespace arbiter::swrast
