#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <optional>
#include <random>

#include "swrast/cover/coverage.h"
#include "swrast/cover/emit.h"
#include "swrast/testing/canvas.h"
#include "util/processor.h"

/// Checks which pixels are covered, against exact references.
namespace arbiter::swrast {
namespace {

using testing::Canvas;
using testing::drawAll;
using testing::WindowVertices;

/// Draws a mesh with irregular corners, on and off pixel centres. Its border lies outside the
/// canvas.
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

/// Decides exactly whether a pixel is inside: 64-bit edge functions at its centre, and the fill
/// rule spelled out.
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
    // Positions are multiples of the subpixel grid, so the reference needs no snapping. Many lie on
    // pixel centres, and many triangles are thin.
    const int unit = round % 3 == 0 ? 256 : round % 3 == 1 ? 16 : 1;
    std::uniform_int_distribution<int> place(0, kSize * 256 / unit);
    std::int64_t x[40][3], y[40][3];
    const int triangles = round % 2 ? 1 : 40; // one triangle is shaded in bands, 40 in tiles
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

/// Returns the kernels of this processor beyond the baseline.
std::vector<const CoverKernels *> otherKernels() {
  std::vector<const CoverKernels *> others;
#if defined(__x86_64__) || defined(__i386__)
  if (vectors() >= Vectors::Avx2)
    others.push_back(&kCoverAvx2);
#endif
  others.push_back(&chooseCoverKernels());
  return others;
}

/// Returns the triangle with these corners, if a pixel centre may be inside.
std::optional<SmallTriangle> smallOf(WindowVertex (&corner)[3]) {
  for (WindowVertex &v : corner) {
    v.x = float(v.fixedX) / kSubpixels + 0.5f;
    v.y = float(v.fixedY) / kSubpixels + 0.5f;
    v.z = v.inverseW = 1;
    v.outcode = 0;
  }
  const SmallSetUp with(RasterState(), {-4096, -4096, 8192, 8192});
  TriangleGroup group = {};
  group.count = 1;
  for (auto &vertex : group.vertex)
    vertex[0] = std::uint32_t(&vertex - group.vertex);
  SmallTriangle made[TriangleGroup::kMax];
  if (setUpSmallBaseline(with, corner, group, made).small == 0)
    return std::nullopt;
  return made[0];
}

TEST(Rasterize, SmallTrianglesAreTheSameOnAllInstructionSets) {
  const std::vector<const CoverKernels *> others = otherKernels();
  std::mt19937 random(11);
  std::uniform_int_distribution<std::int32_t> place(0, kSmallExtent - 1), origin(-8, 8);
  for (int round = 0; round < 3000; ++round) {
    WindowVertex corner[3];
    const std::int32_t shiftX = origin(random) * kSmallExtent, shiftY = origin(random) * 256;
    for (WindowVertex &v : corner) {
      v.fixedX = place(random) / (1 + round % 7) + shiftX;
      v.fixedY = place(random) / (1 + round % 5) + shiftY;
    }
    std::optional<SmallTriangle> triangle = smallOf(corner);
    if (!triangle)
      continue;
    const Rect part = {triangle->left, triangle->bottom, triangle->right - triangle->left,
                       triangle->top - triangle->bottom};
    for (const int lanes : {4, 8, 16}) {
      std::vector<abi::Block> expected(2048), blocks(2048);
      const Cover cover = kCoverBaseline.small(*triangle, part, lanes, expected.data());
      for (const CoverKernels *other : others) {
        const Cover same = other->small(*triangle, part, lanes, blocks.data());
        ASSERT_EQ(same.blocks, cover.blocks);
        ASSERT_EQ(same.pixels, cover.pixels);
        ASSERT_EQ(std::memcmp(blocks.data(), expected.data(), cover.blocks * sizeof(abi::Block)),
                  0);
      }
    }
  }
}

/// Returns a random triangle around a tile; some are thin, some far larger than the tile.
Shape shapeAround(std::mt19937 &random, int round, const Rect &tile) {
  const std::int32_t reach = 64 << (round % 8); // pixels
  std::uniform_int_distribution<std::int32_t> place(-reach * kSubpixels, reach * kSubpixels);
  // odd rounds: any subpixel; even rounds: often on pixel centres
  const std::int32_t unit = round % 2 ? 1 : 128;
  Shape shape;
  for (;;) {
    WindowVertex corner[3];
    for (WindowVertex &v : corner) {
      v.fixedX = (tile.x + 32) * kSubpixels + place(random) / unit * unit;
      v.fixedY = (tile.y + 32) * kSubpixels + place(random) / unit * unit;
    }
    if (round % 5 == 0) { // makes a sliver
      corner[2].fixedX = corner[1].fixedX + 300;
      corner[2].fixedY = corner[1].fixedY - 200;
    }
    const std::int64_t area = areaOf(corner);
    if (area != 0 && shapeOf({-32768, -32768, 65536, 65536}, corner, area, shape))
      return shape;
  }
}

bool isInside(const Shape &shape, int x, int y) {
  return std::all_of(shape.edges, shape.edges + shape.edgeCount, [&](const Edge &edge) {
    return std::int64_t(edge.a) * x + std::int64_t(edge.b) * y + edge.c >= 0;
  });
}

TEST(Rasterize, RegionsAreExactOnAllInstructionSets) {
  std::vector<const CoverKernels *> all = otherKernels();
  all.push_back(&kCoverBaseline);
  std::mt19937 random(13);
  int covered = 0;
  for (int round = 0; round < 4000; ++round) {
    const Rect tile = {64 * int(random() % 128), 64 * int(random() % 128), 64, 64};
    const int left = int(random() % 32), bottom = int(random() % 32);
    const Rect part = round % 3 == 0 ? tile
                                     : Rect{tile.x + left, tile.y + bottom,
                                            1 + int(random() % unsigned(64 - left)),
                                            1 + int(random() % unsigned(64 - bottom))};
    const Shape shape = shapeAround(random, round, tile);
    ASSERT_TRUE(fitsRegions(shape));
    std::vector<bool> expected(64 * 64);
    unsigned pixels = 0;
    for (int y = part.y; y < part.y + part.height; ++y)
      for (int x = part.x; x < part.x + part.width; ++x) {
        const bool inside = isInside(shape, x, y);
        expected[std::size_t((y & 63) * 64 + (x & 63))] = inside;
        pixels += inside ? 1 : 0;
      }
    covered += pixels != 0 ? 1 : 0;
    Region region;
    if (!regionOf(shape, part, region)) {
      ASSERT_EQ(pixels, 0u);
      continue;
    }
    for (const int lanes : {4, 8, 16}) {
      const int width = lanes == 4 ? 2 : 4;
      for (const CoverKernels *kernels : all) {
        std::vector<abi::Block> blocks(1025);
        const Cover cover = kernels->region(region, lanes, blocks.data());
        ASSERT_EQ(cover.pixels, pixels) << "round " << round;
        std::vector<bool> seen(64 * 64);
        for (std::uint32_t i = 0; i < cover.blocks; ++i) {
          ASSERT_NE(blocks[i].mask, 0);
          for (int lane = 0; lane < lanes; ++lane)
            if (blocks[i].mask >> lane & 1) {
              const int x = blocks[i].x + lane % width, y = blocks[i].y + lane / width;
              ASSERT_TRUE(x >= tile.x && x < tile.x + 64 && y >= tile.y && y < tile.y + 64);
              seen[std::size_t((y & 63) * 64 + (x & 63))] = true;
            }
        }
        ASSERT_EQ(seen, expected) << "round " << round << ", " << lanes << " lanes";
      }
    }
  }
  EXPECT_GT(covered, 1000); // many of the shapes must reach their tile
}

/// Checks how the emitter draws large shapes, stippled or not, and shapes whose edges need 64 bits.
TEST(Rasterize, LargeShapesAreShadedByBlocks) {
  std::mt19937 random(17);
  std::vector<std::uint8_t> stipple(128);
  for (std::uint8_t &byte : stipple)
    byte = std::uint8_t(random());
  for (int round = 0; round < 240; ++round) {
    Canvas canvas(150, 140);
    canvas.useQuads(2 << (1 + round % 3));
    const bool stippled = round / 3 % 2 != 0, wide = round % 8 == 7;
    canvas.state.polygonStipple = stippled ? stipple.data() : nullptr;
    Shape shape = shapeAround(random, round, {64, 64, 64, 64});
    if (wide) {
      constexpr std::int32_t kScale = 256; // makes the longest edges just fit 32 bits
      for (Edge &edge : shape.edges)
        edge = {edge.a * kScale, edge.b * kScale,
                edge.c * kScale - std::int64_t(random() % kScale)};
      ASSERT_FALSE(fitsRegions(shape)) << "round " << round;
    }
    const Rect drawn =
        intersect(canvas.state.clip,
                  {shape.left, shape.bottom, shape.right - shape.left, shape.top - shape.bottom});
    shape.stippled = stippled;
    std::uint64_t pixels = 0;
    {
      Emitter emitter(canvas.state, canvas.shading);
      emitter.shade(shape, 3, 5, 147, 133);
      pixels = emitter.pixels();
    }
    std::uint64_t expected = 0;
    for (int y = 0; y < canvas.height; ++y)
      for (int x = 0; x < canvas.width; ++x) {
        const bool isSet =
            (stipple[std::size_t(4 * (y & 31) + (x & 31) / 8)] >> (7 - x % 8) & 1) != 0;
        const bool isHere = x >= std::max(3, drawn.x) && x < std::min(147, drawn.x + drawn.width) &&
                            y >= std::max(5, drawn.y) && y < std::min(133, drawn.y + drawn.height);
        const unsigned count = isHere && isInside(shape, x, y) && (!stippled || isSet) ? 1 : 0;
        ASSERT_EQ(canvas.at(x, y), count) << x << ", " << y << " in round " << round;
        expected += count;
      }
    EXPECT_EQ(pixels, expected);
  }
}

} // namespace
} // namespace arbiter::swrast
