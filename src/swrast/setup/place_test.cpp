#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "swrast/setup/place.h"
#include "util/processor.h"

namespace arbiter::swrast {
namespace {

/// Returns clip coordinates: most lie inside, some are extreme values.
std::vector<float> coordinates(std::mt19937 &random, std::size_t count, float low, float high) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kSpecial[] = {
      0,          -0.0f,   1,     -1,     0.5f,
      1e-40f,     -1e-40f, 3e38f, -3e38f, kInfinity,
      -kInfinity, 1e-20f,  1e20f, -4e6f,  std::numeric_limits<float>::quiet_NaN()};
  std::uniform_real_distribution<float> value(low, high);
  std::vector<float> result(count);
  for (float &each : result)
    each = random() % 8 == 0 ? kSpecial[random() % std::size(kSpecial)] : value(random);
  return result;
}

struct Case {
  int upsideDownHeight;
  bool depthClamp;
  unsigned planes; ///< number of user clip planes
};

void compare(PlaceVertices place, const Case &each, std::mt19937 &random) {
  const std::uint32_t count = 1 + random() % 70, begin = random() % count;
  std::vector<float> position[4], distance[8];
  Vertices vertices;
  vertices.count = count;
  for (int c = 0; c < 4; ++c) {
    position[c] = coordinates(random, count, c == 3 ? 0.5f : -1.2f, c == 3 ? 3.0f : 1.2f);
    vertices.position[c] = position[c].data();
  }
  for (unsigned plane = 0; plane < each.planes; ++plane) {
    distance[plane * 3] = coordinates(random, count, -1, 3);
    vertices.clipDistance[plane * 3] = distance[plane * 3].data();
  }
  RasterState state;
  const float viewport[4] = {3, -7, 640.5f, 481};
  std::copy(viewport, viewport + 4, state.viewport);
  state.depthNear = 0.25f;
  state.upsideDownHeight = each.upsideDownHeight;
  state.depthClamp = each.depthClamp;
  const Viewport made = makeViewport(state, vertices);
  // The element after the end must stay as it is.
  WindowVertex untouched{};
  untouched.x = 7;
  std::vector<WindowVertex> window(count + 1, untouched);
  const PlacedBounds bounds = place(made, vertices, begin, count, window.data());
  PlacedBounds expected;
  constexpr std::size_t kBytes = offsetof(WindowVertex, outcode) + sizeof(WindowVertex::outcode);
  for (std::uint32_t i = begin; i < count; ++i) {
    const WindowVertex one = windowVertex(made, vertices, i);
    ASSERT_EQ(std::memcmp(&one, &window[i], kBytes), 0)
        << i << " of " << count << ": " << one.x << ' ' << window[i].x << ' ' << one.fixedX << ' '
        << window[i].fixedX << ' ' << one.outcode << ' ' << window[i].outcode;
    expected.add({one.outcode, one.fixedX, one.fixedY, one.fixedX, one.fixedY});
  }
  EXPECT_EQ(window[count].x, 7);
  EXPECT_EQ(bounds.outcodes, expected.outcodes);
  EXPECT_EQ(bounds.minX, expected.minX);
  EXPECT_EQ(bounds.minY, expected.minY);
  EXPECT_EQ(bounds.maxX, expected.maxX);
  EXPECT_EQ(bounds.maxY, expected.maxY);
}

void compareMany(PlaceVertices place) {
  std::mt19937 random(12);
  for (int i = 0; i < 500 && !::testing::Test::HasFatalFailure(); ++i)
    for (const Case &each : {Case{0, false, 0}, Case{481, false, 0}, Case{480, true, 3}})
      compare(place, each, random);
}

TEST(Place, PlacesVerticesAsOneAtATimeIsPlaced) { compareMany(placeVerticesBaseline); }

TEST(Place, PlacesFourCornersAsOneAtATimeIsPlaced) {
  std::mt19937 random(13);
  constexpr std::uint32_t kCount = 9;
  for (int round = 0; round < 2000; ++round) {
    std::vector<float> position[4], distance;
    Vertices vertices;
    vertices.count = kCount;
    for (int c = 0; c < 4; ++c) {
      position[c] = coordinates(random, kCount, c == 3 ? 0.5f : -1.2f, c == 3 ? 3.0f : 1.2f);
      vertices.position[c] = position[c].data();
    }
    distance = coordinates(random, kCount, -1, 3);
    if (round % 2 != 0)
      vertices.clipDistance[5] = distance.data();
    RasterState state;
    const float viewport[4] = {3, -7, 640.5f, 481};
    std::copy(viewport, viewport + 4, state.viewport);
    state.upsideDownHeight = round % 3 == 0 ? 481 : 0;
    state.depthClamp = round % 5 == 0;
    const Viewport made = makeViewport(state, vertices);
    const std::uint32_t index[4] = {std::uint32_t(random()) % kCount,
                                    std::uint32_t(random()) % kCount,
                                    std::uint32_t(random()) % kCount, kCount - 1};
    WindowVertex four[4];
    placeCorners(made, vertices, index, four);
    for (int i = 0; i < 4; ++i) {
      const WindowVertex one = windowVertex(made, vertices, index[i]);
      ASSERT_EQ(std::memcmp(&one, &four[i],
                            offsetof(WindowVertex, outcode) + sizeof(WindowVertex::outcode)),
                0)
          << round << ", corner " << i;
    }
  }
}

#if defined(__x86_64__) || defined(__i386__)
TEST(Place, PlacesThemSoWithAvx2) {
  if (vectors() < Vectors::Avx2)
    GTEST_SKIP() << "this processor does not run code for avx2";
  compareMany(placeVerticesAvx2);
}

TEST(Place, PlacesThemSoWithAvx512) {
  if (vectors() < Vectors::Avx512)
    GTEST_SKIP() << "this processor does not run code for avx512";
  compareMany(placeVerticesAvx512);
}
#endif

} // namespace
} // namespace arbiter::swrast
