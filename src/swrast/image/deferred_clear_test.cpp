#include "swrast/image/deferred_clear.h"

#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "swrast/image/copy_pixels.h"
#include "swrast/image/image.h"
#include "swrast/threads.h"

/// Checks that deferred clears give the same pixels as clears written at once.
namespace arbiter::swrast {
namespace {

constexpr abi::Swizzle kRgba = {abi::From::C0, abi::From::C1, abi::From::C2, abi::From::C3};
constexpr abi::Format kColor = {abi::Layout::U8x4, kRgba};
constexpr abi::Format kHalves = {abi::Layout::F16x4, kRgba};
constexpr abi::Format kDepth = {abi::Layout::Depth24Stencil8, kRgba};
constexpr abi::Format kDepth16 = {abi::Layout::Depth16, kRgba};

/// The image has several tiles; the last ones in each row and column are partial.
constexpr int kWidth = 200, kHeight = 150;

Image imageOf(const abi::Format &format, bool topRowFirst = false) {
  Image image = makeImage(format, kWidth, kHeight, 1, topRowFirst);
  for (int y = 0; y < kHeight; ++y)
    std::memset(image.pixel(0, y), 0x5A, std::size_t(kWidth) * abi::bytesOf(format.layout));
  return image;
}

bool isPending(const Image &image) { return image.storage->pendingClear() != nullptr; }

std::vector<std::uint8_t> bytesOf(const Image &image) {
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < kHeight; ++y) {
    const std::uint8_t *const row = image.placeOf(0, y);
    bytes.insert(bytes.end(), row,
                 row + std::ptrdiff_t(kWidth) * abi::bytesOf(image.format.layout));
  }
  return bytes;
}

TEST(DeferredClear, IsWrittenWhereItIsReachedAndNowhereElse) {
  Image image = imageOf(kColor);
  const float red[] = {1, 0, 0, 1};
  fill(image, {0, 0, kWidth, kHeight}, red);
  ASSERT_TRUE(isPending(image));
  EXPECT_EQ(*image.placeOf(100, 100), 0x5A);
  image.storage->pendingClear()->reach({70, 70, 1, 1});
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool reached = x >= 64 && x < 128 && y >= 64 && y < 128;
      ASSERT_EQ(*image.placeOf(x, y), reached ? 0xFF : 0x5A) << x << ", " << y;
    }
  EXPECT_EQ(*image.pixel(0, 0), 0xFF);
  EXPECT_FALSE(isPending(image));
  EXPECT_EQ(*image.placeOf(kWidth - 1, kHeight - 1), 0xFF);
}

TEST(DeferredClear, IsForgottenWhereAllIsReplaced) {
  Image image = imageOf(kColor);
  const float red[] = {1, 0, 0, 1};
  fill(image, {0, 0, kWidth, kHeight}, red);
  ASSERT_TRUE(makeWritable(image, false));
  EXPECT_FALSE(isPending(image));
  EXPECT_EQ(*image.pixel(0, 0), 0x5A);
}

TEST(DeferredClear, IsInCopiesOfTheImage) {
  Image image = imageOf(kColor);
  const float red[] = {1, 0, 0, 1};
  fill(image, {0, 0, kWidth, kHeight}, red);
  const Image shared = image;
  ASSERT_TRUE(makeWritable(image, true));
  EXPECT_NE(image.storage, shared.storage);
  EXPECT_EQ(*image.pixel(9, 9), 0xFF);
  EXPECT_EQ(*shared.pixel(9, 9), 0xFF);
}

TEST(DeferredClear, KeepsItsMemoryForTheNextImage) {
  const float red[] = {1, 0, 0, 1};
  DeferredClear *seen = nullptr;
  for (int i = 0; i < 3; ++i) {
    Image image = imageOf(kColor);
    fill(image, {0, 0, kWidth, kHeight}, red);
    if (seen) {
      EXPECT_EQ(image.storage->pendingClear(), seen);
    }
    seen = image.storage->pendingClear();
  }
}

/// Applies the same commands to two images, one of which completes each clear at once.
class Twins {
public:
  explicit Twins(const abi::Format &format, bool topRowFirst)
      : m_late(imageOf(format, topRowFirst)), m_atOnce(imageOf(format, topRowFirst)) {}
  template <typename Clear> void clear(const Clear &command) {
    command(m_late);
    command(m_atOnce);
    m_atOnce.complete();
  }
  /// Acts as a draw does: it reaches the rectangle, then writes to it.
  void draw(const Rect &rect, std::uint8_t byte) {
    if (DeferredClear *const clear = m_late.storage->pendingClear())
      clear->reach(rect);
    for (Image *image : {&m_late, &m_atOnce})
      for (int y = rect.y; y < rect.y + rect.height; ++y) {
        const int bytes = rect.width * abi::bytesOf(image->format.layout);
        std::uint8_t *const row = image->placeOf(rect.x, y);
        for (int i = 0; i < bytes; ++i)
          row[i] = std::uint8_t(row[i] + byte); // depends on the cleared value
      }
  }
  void expectEqual() {
    m_late.complete();
    EXPECT_EQ(bytesOf(m_late), bytesOf(m_atOnce));
  }
  [[nodiscard]] bool isPending() const { return swrast::isPending(m_late); }

private:
  Image m_late, m_atOnce;
};

TEST(DeferredClear, AnyOrderOfClearsAndDrawsGivesThePixelsOfClearsAtOnce) {
  std::mt19937 random(7);
  const auto below = [&](int end) { return int(random() % unsigned(end)); };
  const auto someRect = [&] {
    const int x = below(kWidth), y = below(kHeight);
    return Rect{x, y, 1 + below(kWidth - x), 1 + below(kHeight - y)};
  };
  constexpr Rect kAll = {0, 0, kWidth, kHeight};
  int late = 0;
  for (const abi::Format &format : {kColor, kHalves, kDepth, kDepth16})
    for (int run = 0; run < 40; ++run) {
      Twins twins(format, run % 2 == 1);
      for (int step = 0; step < 12; ++step) {
        const Rect rect = below(3) == 0 ? someRect() : kAll;
        const float value[] = {float(below(5)) / 4, float(below(5)) / 4, float(below(5)) / 4,
                               float(below(5)) / 4};
        const auto mask = unsigned(below(16));
        if (below(2) == 0)
          twins.draw(someRect(), std::uint8_t(below(256)));
        else if (abi::componentsOf(format.layout) != 0)
          twins.clear([&](Image &image) { fill(image, rect, value, mask); });
        else
          twins.clear([&](Image &image) {
            fillDepthStencil(image, rect, mask % 4 != 0, value[0],
                             mask < 8 ? std::uint8_t(0) : std::uint8_t(0x3F), 0xA5);
          });
        late += twins.isPending();
      }
      twins.expectEqual();
      ASSERT_FALSE(testing::Test::HasFailure()) << "run " << run;
    }
  EXPECT_GT(late, 400) << "hardly any clear was deferred";
}

TEST(DeferredClear, IsCompletedOnAllThreads) {
  setThreadCount(4);
  Image image = makeImage(kColor, 1000, 700);
  const float red[] = {1, 0, 0, 1};
  fill(image, {0, 0, 1000, 700}, red);
  image.storage->pendingClear()->reach({300, 300, 10, 10});
  image.complete();
  setThreadCount(0);
  for (int y = 0; y < 700; ++y)
    for (int x = 0; x < 1000; ++x)
      ASSERT_EQ(*image.placeOf(x, y), 0xFF);
}

} // namespace
} // namespace arbiter::swrast
