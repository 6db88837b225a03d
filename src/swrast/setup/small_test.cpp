#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "swrast/setup/small.h"
#include "swrast/setup/triangles.h"
#include "util/processor.h"

/// Compares vector setup of small triangles with the functions that set up one triangle.
namespace arbiter::swrast {
namespace {

constexpr std::uint32_t kVertices = 40;
constexpr Rect kClip = {13, 6, 470, 380};

/// Returns vertices that often coincide or lie on a grid, so that areas and depths are often 0 or
/// equal.
std::vector<WindowVertex> randomVertices(std::mt19937 &random, int upsideDownHeight) {
  std::uniform_real_distribution<float> unit(-1, 1);
  std::vector<WindowVertex> window(kVertices);
  const float x = 250 + 260 * unit(random), y = 200 + 230 * unit(random);
  const float reach = random() % 3 == 0 ? 200.0f : 4.0f * float(1 + random() % 10);
  const bool onGrid = random() % 3 == 0;
  for (WindowVertex &vertex : window) {
    vertex.x = x + reach * unit(random);
    vertex.y = y + reach * unit(random);
    vertex.z = random() % 4 == 0 ? 0.25f : 0.5f + 0.5f * unit(random);
    if (onGrid) {
      vertex.x = std::floor(vertex.x) + 0.5f;
      vertex.y = std::floor(vertex.y) + 0.5f;
    }
    if (random() % 12 == 0) { // almost the same place as another vertex
      vertex.x = window[0].x + 1e-4f * unit(random);
      vertex.y = window[0].y;
    }
    vertex.inverseW = 1;
    vertex.outcode = random() % 40 == 0 ? kOutLeft << random() % 8 : 0;
    snapVertex(vertex, upsideDownHeight);
    if (random() % 200 == 0) {
      vertex = {};
      vertex.outcode = kOutNan;
    }
  }
  return window;
}

TriangleGroup randomGroup(std::mt19937 &random) {
  TriangleGroup group = {};
  group.count = 1 + int(random() % TriangleGroup::kMax);
  for (int lane = 0; lane < group.count; ++lane) {
    for (auto &vertex : group.vertex)
      vertex[lane] = std::uint32_t(random() % kVertices);
    // In one half of a quad, the provoking vertex may be no corner.
    group.provoking[lane] =
        random() % 5 == 0 ? std::uint32_t(random() % kVertices) : group.vertex[random() % 3][lane];
  }
  return group;
}

RasterState randomState(std::mt19937 &random) {
  RasterState state;
  state.frontIsClockwise = random() % 2 != 0;
  state.cullBack = random() % 4 == 0;
  state.cullFront = random() % 6 == 0;
  state.provokingIsFirst = random() % 2 != 0;
  state.offsetFill = random() % 2 != 0;
  state.offsetFactor = 1.5f;
  state.offsetUnits = 3;
  state.depthResolution = 1.0 / 16777215;
  state.upsideDownHeight = random() % 2 ? 400 : 0;
  return state;
}

enum class Kind { Unseen, Small, Other };

/// Classifies a triangle by the functions for one triangle.
Kind kindOf(const RasterState &state, const Triangle &triangle, Bounds &bounds) {
  const WindowVertex *const v = triangle.corner;
  const std::uint32_t any = v[0].outcode | v[1].outcode | v[2].outcode;
  if (any != 0)
    return v[0].outcode & v[1].outcode & v[2].outcode & kOutsideMask ? Kind::Unseen : Kind::Other;
  if (!setBounds(kClip, v, 3, bounds))
    return Kind::Unseen;
  const auto extent = [](std::int32_t a, std::int32_t b, std::int32_t c) {
    return std::max({a, b, c}) - std::min({a, b, c});
  };
  if (extent(v[0].fixedX, v[1].fixedX, v[2].fixedX) >= kSmallExtent ||
      extent(v[0].fixedY, v[1].fixedY, v[2].fixedY) >= kSmallExtent)
    return Kind::Other;
  const std::int64_t area = areaOf(v);
  return area == 0 || isCulled(state, isBackFacing(state, area)) ? Kind::Unseen : Kind::Small;
}

void expectSame(const RasterState &state, const Triangle &triangle, const Bounds &bounds,
                bool hasDepth, const SmallTriangle &small) {
  const HostOrder order(state, triangle);
  const WindowVertex *const v = triangle.corner;
  for (int k = 0; k < 3; ++k)
    ASSERT_EQ(small.vertex[k], triangle.vertex[order.corner[k]]);
  ASSERT_EQ(small.provoking(), triangle.provoking);
  ASSERT_EQ(small.isBackFacing(), isBackFacing(state, areaOf(triangle.corner)));
  ASSERT_EQ(small.left, bounds.left);
  ASSERT_EQ(small.bottom, bounds.bottom);
  ASSERT_EQ(small.right, bounds.right);
  ASSERT_EQ(small.top, bounds.top);
  const int left = pixelFrom(std::min({v[0].fixedX, v[1].fixedX, v[2].fixedX}));
  const int bottom = pixelFrom(std::min({v[0].fixedY, v[1].fixedY, v[2].fixedY}));
  ASSERT_EQ(small.originX, std::max(left, 0));
  ASSERT_EQ(small.originY, std::max(bottom, 0));
  Shape shape;
  ASSERT_TRUE(shapeOf(kClip, triangle.corner, areaOf(triangle.corner), shape));
  for (int i = 0; i < 3; ++i) {
    const Edge &edge = shape.edges[i];
    ASSERT_EQ(i < 2 ? small.a[i] : -(small.a[0] + small.a[1]), edge.a);
    ASSERT_EQ(i < 2 ? small.b[i] : -(small.b[0] + small.b[1]), edge.b);
    ASSERT_EQ(small.c[i],
              edge.a * std::int64_t(small.originX) + edge.b * std::int64_t(small.originY) + edge.c);
  }
  if (!hasDepth)
    return;
  const PlaneSteps steps(state, {&v[order.corner[0]], &v[order.corner[1]], &v[order.corner[2]]});
  const abi::DepthPlane expected = makeDepthPlane(state, steps, state.offsetFill);
  const float values[4] = {expected.c, expected.dx, expected.dy, expected.offset};
  ASSERT_EQ(std::memcmp(values, small.depth, sizeof values), 0);
}

std::vector<SetUpSmall> allKernels() {
  std::vector<SetUpSmall> all = {setUpSmallBaseline};
#if defined(__x86_64__) || defined(__i386__)
  if (vectors() >= Vectors::Avx2)
    all.push_back(setUpSmallAvx2);
  if (vectors() >= Vectors::Avx512)
    all.push_back(setUpSmallAvx512);
#endif
  return all;
}

class Small : public ::testing::TestWithParam<SetUpSmall> {};
INSTANTIATE_TEST_SUITE_P(Processors, Small, ::testing::ValuesIn(allKernels()),
                         [](const auto &row) { return std::to_string(row.index); });

TEST_P(Small, IsWhatTheFunctionsForOneSay) {
  std::mt19937 random(5);
  int smalls = 0, others = 0, depthless = 0;
  for (int round = 0; round < 20000; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const RasterState state = randomState(random);
    const std::vector<WindowVertex> window = randomVertices(random, state.upsideDownHeight);
    const TriangleGroup group = randomGroup(random);
    std::vector<SmallTriangle> made(TriangleGroup::kMax);
    const GroupSetUp found =
        GetParam()(SmallSetUp(state, kClip), window.data(), group, made.data());
    int next = 0;
    for (int lane = 0; lane < group.count; ++lane) {
      Triangle triangle;
      for (int k = 0; k < 3; ++k) {
        triangle.vertex[k] = group.vertex[k][lane];
        triangle.corner[k] = window[triangle.vertex[k]];
      }
      triangle.provoking = group.provoking[lane];
      Bounds bounds;
      const Kind kind = kindOf(state, triangle, bounds);
      ASSERT_EQ(found.small >> lane & 1, kind == Kind::Small ? 1u : 0u) << "lane " << lane;
      ASSERT_EQ(found.other >> lane & 1, kind == Kind::Other ? 1u : 0u) << "lane " << lane;
      others += kind == Kind::Other ? 1 : 0;
      if (kind != Kind::Small)
        continue;
      const bool hasDepth = (found.depthless >> lane & 1) == 0;
      ++smalls;
      depthless += hasDepth ? 0 : 1;
      ASSERT_NO_FATAL_FAILURE(
          expectSame(state, triangle, bounds, hasDepth, made[std::size_t(next++)]));
    }
    ASSERT_EQ((found.small | found.other) >> group.count, 0u);
    ASSERT_EQ(found.depthless & ~found.small, 0u);
  }
  EXPECT_GT(smalls, 10000);
  EXPECT_GT(others, 1000);
  EXPECT_LT(depthless, smalls / 50);
}

} // namespace
} // namespace arbiter::swrast
