#include "swrast/bits.h"

#include <random>

#include <gtest/gtest.h>

#include "swrast/testing/canvas.h"

namespace arbiter::swrast {
namespace {

using testing::Canvas;

/// A bitmap of random bits with a random memory layout and position.
struct RandomBits {
  explicit RandomBits(std::uint32_t seed) : numbers(seed) {
    const auto below = [&](int count) { return int(numbers() % unsigned(count)); };
    image.width = 1 + below(40);
    image.height = 1 + below(24);
    image.skip = below(19);
    image.lowestFirst = below(2) != 0;
    image.stride = (image.skip + image.width + 7) / 8 + below(3);
    for (std::int64_t i = 0; i < image.stride * image.height; ++i)
      memory.push_back(std::uint8_t(below(4) == 0 ? 0 : below(4) == 1 ? 0xFF : below(256)));
    image.rows = memory.data();
    x = below(90) - 30;
    y = below(70) - 20;
  }
  /// Returns a bit, located by the rules of the specification (3.6.4, 3.7) and not by BitImage's
  /// code.
  [[nodiscard]] bool set(int column, int row) const {
    const int bit = image.skip + column;
    const std::uint8_t byte = memory[std::size_t(row * image.stride + bit / 8)];
    const int mask = image.lowestFirst ? 1 << bit % 8 : 128 >> bit % 8;
    return (byte & mask) != 0;
  }
  std::mt19937 numbers;
  std::vector<std::uint8_t> memory;
  BitImage image;
  int x = 0, y = 0;
};

/// Expects each pixel of the clip rectangle to be drawn once if its bit is set, and no other pixel.
/// \param lanes 0 draws rows, other values blocks
void expectBits(std::uint32_t seed, int lanes) {
  const RandomBits bits(seed);
  Canvas canvas(61, 47);
  if (lanes != 0)
    canvas.useQuads(lanes);
  canvas.state.clip = {3, 2, 50, 41};
  canvas.shading.inputCount = 1;
  BitFragments fragments;
  fragments.inputs[0][0] = 0.25f;
  const DrawStatistics drawn =
      rasterizeBits(canvas.state, canvas.shading, bits.image, bits.x, bits.y, fragments);
  std::uint64_t expected = 0;
  for (int y = 0; y < canvas.height; ++y)
    for (int x = 0; x < canvas.width; ++x) {
      const int column = x - bits.x, row = y - bits.y;
      const bool inside = x >= 3 && x < 53 && y >= 2 && y < 43 && column >= 0 &&
                          column < bits.image.width && row >= 0 && row < bits.image.height;
      const bool covered = inside && bits.set(column, row);
      expected += covered;
      ASSERT_EQ(canvas.at(x, y), covered ? 1u : 0u) << "pixel " << x << ", " << y;
      if (covered) {
        ASSERT_EQ(canvas.valueAt(x, y), 0.25f);
      }
    }
  EXPECT_EQ(drawn.pixels, expected);
}

TEST(Bits, SetBitsAreFragments) {
  for (std::uint32_t seed = 0; seed < 300; ++seed)
    for (const int lanes : {0, 4, 8, 16}) {
      expectBits(seed, lanes);
      ASSERT_FALSE(HasFailure()) << "seed " << seed << ", lanes " << lanes;
    }
}

TEST(Bits, ManySpansAreGivenInParts) {
  std::vector<std::uint8_t> memory(64 * 8, 0x55);
  const BitImage image = {memory.data(), 8, 0, false, 64, 64};
  Canvas canvas(64, 64);
  EXPECT_EQ(rasterizeBits(canvas.state, canvas.shading, image, 0, 0, {}).pixels, 64u * 32u);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      ASSERT_EQ(canvas.at(x, y), unsigned(x % 2));
}

TEST(Bits, NothingOutsideIsRead) {
  const BitImage image = {nullptr, 8, 0, false, 64, 64};
  Canvas canvas(16, 16);
  EXPECT_EQ(rasterizeBits(canvas.state, canvas.shading, image, 16, 0, {}).pixels, 0u);
  EXPECT_EQ(rasterizeBits(canvas.state, canvas.shading, image, -64, 3, {}).pixels, 0u);
}

} // namespace
} // namespace arbiter::swrast
