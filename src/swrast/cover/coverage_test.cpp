#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <random>

#include "swrast/cover/small.h"
#include "swrast/testing/canvas.h"
#include "util/processor.h"

/// Which pixels are covered, against exact references.
namespace arbiter::swrast {
namespace {

using testing::Canvas;
using testing::drawAll;
using testing::WindowVertices;

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

/// The exact answer for one pixel: edge functions of 64 bits at its centre, the fill rule in words.
bool isInside(const std::int64_t (&x)[3], const std::int64_t (&y)[3], int px, int py) {
  const std::int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  if (area == 0)
    return false;
  for (int i = 0; i < 3; ++i) {
    const int a = i, b = (i + 1) % 3;
    std::int64_t dx = x[b] - x[a], dy = y[b] - y[a];
    if (area < 0) {
      dx = -dx;
      dy = -dy;
    }
    const std::int64_t side = dx * (py * 256 - y[a]) - dy * (px * 256 - x[a]);
    const bool isLeft = dy < 0, isLower = dy == 0 && dx > 0;
    if (side < 0 || (side == 0 && !isLeft && !isLower))
      return false;
  }
  return true;
}

TEST(Rasterize, CoverageIsExact) {
  std::mt19937 random(3);
  constexpr int kSize = 48;
  for (int round = 0; round < 1500; ++round) {
    Canvas canvas(kSize, kSize);
    if (round % 4 != 0)
      canvas.useQuads(2 << (round % 4));
    // Snapped places, so that the reference need not know how places are snapped; many of them on
    // pixel centres, many triangles thin.
    const int unit = round % 3 == 0 ? 256 : round % 3 == 1 ? 16 : 1;
    std::uniform_int_distribution<int> place(0, kSize * 256 / unit);
    std::int64_t x[40][3], y[40][3];
    const int triangles = round % 2 ? 1 : 40; // in bands, in tiles
    WindowVertices vertices(canvas);
    for (int t = 0; t < triangles; ++t) {
      for (int k = 0; k < 3; ++k) {
        const int wx = std::min(place(random) * unit + 128, kSize * 256);
        const int wy = std::min(place(random) * unit + 128, kSize * 256);
        x[t][k] = wx - 128;
        y[t][k] = wy - 128;
        vertices.add(wx / 256.0, wy / 256.0);
      }
    }
    const DrawStatistics statistics = drawAll(canvas, Topology::Triangles, vertices);
    std::uint64_t pixels = 0;
    for (int py = 0; py < kSize; ++py)
      for (int px = 0; px < kSize; ++px) {
        std::uint32_t expected = 0;
        for (int t = 0; t < triangles; ++t)
          expected += isInside(x[t], y[t], px, py);
        ASSERT_EQ(canvas.at(px, py), expected) << px << ", " << py << " in round " << round;
        pixels += expected;
      }
    EXPECT_EQ(statistics.pixels, pixels);
  }
}

TEST(Rasterize, FansCoverEachPixelOnce) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> at(20, 44);
  for (int round = 0; round < 60; ++round) {
    Canvas canvas(64, 64);
    WindowVertices vertices(canvas);
    vertices.add(round % 2 ? 32.5 : at(random), round % 2 ? 31.5 : at(random));
    const int spokes = 3 + round * 2;
    for (int i = 0; i <= spokes; ++i) {
      const double angle = (i % spokes) * 2 * M_PI / spokes;
      vertices.add(32 + 100 * std::cos(angle), 32 + 100 * std::sin(angle));
    }
    drawAll(canvas, Topology::TriangleFan, vertices);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x)
        ASSERT_EQ(canvas.at(x, y), 1u) << x << ", " << y << " in round " << round;
  }
}

TEST(Rasterize, SmallTrianglesAreTheSameOnAllInstructionSets) {
  std::vector<CoverSmall> others;
#if defined(__x86_64__) || defined(__i386__)
  if (vectors() >= Vectors::Avx2)
    others.push_back(coverSmallAvx2);
#endif
  others.push_back(chooseCoverSmall());
  std::mt19937 random(11);
  std::uniform_int_distribution<std::int32_t> place(0, kSmallExtent - 1), origin(-8, 8);
  for (int round = 0; round < 3000; ++round) {
    WindowVertex corner[3];
    const std::int32_t shiftX = origin(random) * kSmallExtent, shiftY = origin(random) * 256;
    for (WindowVertex &v : corner) {
      v.fixedX = place(random) / (1 + round % 7) + shiftX;
      v.fixedY = place(random) / (1 + round % 5) + shiftY;
    }
    const std::int64_t area = areaOf(corner);
    Bounds bounds;
    if (area == 0 || !setBounds({-4096, -4096, 8192, 8192}, corner, 3, bounds))
      continue;
    for (const int lanes : {4, 8, 16}) {
      std::vector<abi::Block> expected(2048), blocks(2048);
      const SmallCover cover = coverSmallBaseline(corner, area > 0, bounds, lanes, expected.data());
      for (const CoverSmall other : others) {
        const SmallCover same = other(corner, area > 0, bounds, lanes, blocks.data());
        ASSERT_EQ(same.blocks, cover.blocks);
        ASSERT_EQ(same.pixels, cover.pixels);
        ASSERT_EQ(std::memcmp(blocks.data(), expected.data(), cover.blocks * sizeof(abi::Block)),
                  0);
      }
    }
  }
}

} // namespace
} // namespace arbiter::swrast
