#include "swrast/image/copy_pixels.h"
#include "swrast/image/image.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <vector>

#include "swrast/image/pixel_values.h"
#include "util/numbers/half.h"

namespace arbiter::swrast {
namespace {

using abi::Format;
using abi::From;
using abi::Layout;

constexpr Format kRgba8 = {Layout::U8x4, abi::kRgba};
constexpr Format kBgra8 = {Layout::U8x4, {From::C2, From::C1, From::C0, From::C3}};
constexpr Format kRgb8 = {Layout::U8x4, {From::C0, From::C1, From::C2, From::One}};
constexpr Format kLuminance8 = {Layout::U8x1, {From::C0, From::C0, From::C0, From::One}};
constexpr Format kAlpha8 = {Layout::U8x1, {From::Zero, From::Zero, From::Zero, From::C0}};
constexpr Format kRgba32f = {Layout::F32x4, abi::kRgba};
constexpr Format kRgba16f = {Layout::F16x4, abi::kRgba};
constexpr Format kRgba16 = {Layout::U16x4, abi::kRgba};

std::vector<int> bytesAt(const Image &image, int x, int y) {
  const std::uint8_t *const pixel = image.pixel(x, y);
  return {pixel, pixel + abi::bytesOf(image.format.layout)};
}

TEST(Image, SizesOutOfRangeMakeNone) {
  for (const int size : {0, -1, 16385, 1 << 30}) {
    EXPECT_TRUE(makeImage(kRgba8, size, 1).empty());
    EXPECT_TRUE(makeImage(kRgba8, 1, size).empty());
    EXPECT_TRUE(makeImage(kRgba8, 1, 1, size).empty());
  }
  EXPECT_TRUE(makeImage({}, 4, 4).empty());
  EXPECT_FALSE(makeImage(kRgba8, 16384, 1).empty());
}

TEST(Image, SizesBeyondAllAddressesMakeNone) {
  EXPECT_TRUE(makeImage(kRgba32f, 16384, 16384, 16384).empty());
  if (sizeof(void *) == 4) { // a 32-bit product would wrap to half a megabyte
    EXPECT_TRUE(makeImage(kRgba32f, 16384, 8193, 2).empty());
  }
}

TEST(Storage, HoldsNoMoreThanItMay) {
  constexpr std::size_t kBytes = std::size_t(1) << 20;
  const std::uint64_t before = Storage::limitTotal(Storage::totalBytes() + 3 * kBytes + 1024);
  std::vector<std::shared_ptr<Storage>> held;
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(held.emplace_back(Storage::make(kBytes))) << i;
  EXPECT_FALSE(Storage::make(kBytes));
  // Freed storage waits in the pool for a request of its size, and is released if others need the
  // room.
  held.resize(1);
  EXPECT_TRUE(held.emplace_back(Storage::make(kBytes / 2)));
  EXPECT_TRUE(held.emplace_back(Storage::make(kBytes + kBytes / 4)));
  EXPECT_FALSE(Storage::make(kBytes));
  EXPECT_LE(Storage::totalBytes(), Storage::limitTotal(before));
  EXPECT_TRUE(Storage::make(kBytes));
}

TEST(Image, RowsAreAlignedAndTheirSurroundingsReadable) {
  for (const bool topFirst : {false, true}) {
    const Image image = makeImage(kRgba8, 33, 5, 2, topFirst);
    ASSERT_FALSE(image.empty());
    EXPECT_EQ(std::abs(image.rowStride), 192);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(image.pixel(0, 0)) % 64, 0u);
    int sum = 0;
    for (int i = 1; i <= 64; ++i)
      sum += image.storage->data()[-i] +
             image.storage->data()[image.storage->bytes() + std::size_t(i) - 1];
    EXPECT_GE(sum, 0);
    EXPECT_EQ(image.pixel(0, 0) > image.pixel(0, 4), topFirst);
    EXPECT_EQ(image.pixel(1, 2, 1) - image.pixel(0, 2, 0), 5 * 192 + 4);
  }
}

TEST(Image, PackedComponentsAreSetBitByBit) {
  const Format kBits565 = {Layout::Bits565, {From::C0, From::C1, From::C2, From::One}};
  const float some[4] = {1, 0.5f, 0.25f, 1}, none[4] = {};
  Image image = makeImage(kBits565, 5, 3);
  fill(image, {0, 0, 5, 3}, some);
  EXPECT_EQ(bytesAt(image, 4, 2), (std::vector<int>{0x08, 0xFC})) << "11111 100000 01000";
  fill(image, {0, 0, 5, 3}, none, 2);
  EXPECT_EQ(bytesAt(image, 0, 0), (std::vector<int>{0x08, 0xF8}));
  Image wide = makeImage(kRgba16, 5, 3);
  copyPixels(wide, 0, 0, 0, image, {0, 0, 5, 3});
  float rgba[1][4];
  unpackPixels(wide.format, wide.pixel(3, 1), 1, rgba);
  EXPECT_EQ(rgba[0][0], 1.0f);
  EXPECT_EQ(rgba[0][1], 0.0f);
  EXPECT_NEAR(rgba[0][2], 8.0 / 31, 1.0 / 65535);
  EXPECT_EQ(rgba[0][3], 1.0f);
  const Format kBits1010102 = {Layout::Bits1010102, abi::kRgba};
  Image deep = makeImage(kBits1010102, 5, 3);
  copyPixels(deep, 0, 0, 0, wide, {0, 0, 5, 3});
  EXPECT_EQ(bytesAt(deep, 3, 1), (std::vector<int>{0xFF, 0x03, 0x80, 0xD0})) << "264 of 1023";
}

TEST(Image, CopiesShareUntilWritten) {
  Image a = makeImage(kRgba8, 300, 600);
  const float red[4] = {1, 0, 0, 1}, green[4] = {0, 1, 0, 1};
  fill(a, {0, 0, 300, 600}, red);
  Image b = a;
  EXPECT_TRUE(a.shared());
  ASSERT_TRUE(makeWritable(b, true));
  EXPECT_FALSE(a.shared());
  EXPECT_NE(a.storage, b.storage);
  EXPECT_EQ(bytesAt(b, 299, 599), (std::vector<int>{255, 0, 0, 255}));
  fill(b, {0, 0, 300, 600}, green);
  EXPECT_EQ(bytesAt(a, 299, 599), (std::vector<int>{255, 0, 0, 255}));
  const std::uint8_t *const before = b.storage->data();
  ASSERT_TRUE(makeWritable(b, false));
  EXPECT_EQ(b.storage->data(), before) << "its own already";
}

struct Lent {
  alignas(64) std::uint8_t bytes[64 * 8 + 128] = {};
  bool isRead = false, released = false;
  int waits = 0;
  static bool read(void *user, bool wait) {
    Lent &lent = *static_cast<Lent *>(user);
    lent.waits += wait && lent.isRead;
    return lent.isRead = lent.isRead && !wait;
  }
  static void release(void *user) { static_cast<Lent *>(user)->released = true; }
};

TEST(Image, MemoryThatOthersReadIsWaitedForBeforeAWrite) {
  static constexpr Storage::Owner kOwner = {Lent::release, Lent::read};
  Lent lent;
  Image image;
  image.format = kRgba8;
  image.width = 16;
  image.height = 8;
  image.rowStride = 64;
  image.storage = Storage::wrap(lent.bytes + 64, 64 * 8, kOwner, &lent);
  ASSERT_FALSE(image.empty());
  EXPECT_FALSE(image.storage->isRead());
  lent.isRead = true;
  EXPECT_TRUE(image.storage->isRead());
  Image copy = image;
  ASSERT_TRUE(makeWritable(copy, true)); // the copy gets other memory, so it need not wait
  EXPECT_EQ(lent.waits, 0);
  EXPECT_FALSE(copy.storage->isRead());
  ASSERT_TRUE(makeWritable(image, true));
  EXPECT_EQ(lent.waits, 1);
  EXPECT_FALSE(image.storage->isRead());
  image = {};
  EXPECT_TRUE(lent.released);
}

TEST(Image, PingPongAllocatesNothing) {
  Image target = makeImage(kRgba8, 512, 512), texture = target;
  std::size_t afterWarmUp = 0;
  for (int frame = 0; frame < 100; ++frame) {
    ASSERT_TRUE(makeWritable(target, false));
    texture = target;
    if (frame == 4)
      afterWarmUp = Storage::totalBytes();
  }
  EXPECT_EQ(Storage::totalBytes(), afterWarmUp);
}

TEST(Image, ThePoolGivesBackMemoryThatIsTooMuch) {
  const std::size_t before = Storage::totalBytes();
  {
    std::vector<Image> images;
    for (int i = 0; i < 20; ++i)
      images.push_back(makeImage(kRgba8, 1024, 1024));
    EXPECT_GE(Storage::totalBytes(), before + (20u << 22));
  }
  EXPECT_LE(Storage::totalBytes(), before + (20u << 20));
}

TEST(Image, Intersections) {
  EXPECT_EQ(intersect({0, 0, 10, 10}, {5, -5, 10, 10}), (Rect{5, 0, 5, 5}));
  EXPECT_TRUE(intersect({0, 0, 10, 10}, {10, 0, 5, 5}).empty());
  EXPECT_TRUE(intersect({0, 0, -1, 10}, {0, 0, 5, 5}).empty());
  constexpr int kMax = 2147483647;
  EXPECT_EQ(intersect({-5, -5, kMax, kMax}, {0, 0, kMax, kMax}), (Rect{0, 0, kMax - 5, kMax - 5}));
}

TEST(Image, HalvesRoundTripAndRoundToEven) {
  for (std::uint32_t half = 0; half < 0x10000; ++half) {
    const float value = halfToFloat(std::uint16_t(half));
    if (std::isnan(value))
      EXPECT_TRUE(std::isnan(halfToFloat(floatToHalf(value))));
    else
      ASSERT_EQ(floatToHalf(value), half);
  }
  EXPECT_EQ(floatToHalf(1.0f + 0x1p-11f), 0x3C00) << "towards zero";
  EXPECT_EQ(floatToHalf(1.0f + 0x1.8p-10f), 0x3C01);
  EXPECT_EQ(floatToHalf(-1.0f - 0x1.8p-10f), 0xBC01);
  EXPECT_EQ(floatToHalf(65535.0f), 0x7BFF);
  EXPECT_EQ(floatToHalf(1e9f), 0x7BFF);
  EXPECT_EQ(floatToHalf(0x1.8p-24f), 1);
  EXPECT_EQ(floatToHalf(0x1.8p-25f), 0);
}

TEST(Image, CopiesConvertByValue) {
  Image from = makeImage(kRgba8, 70, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 70; ++x)
      for (int c = 0; c < 4; ++c)
        from.pixel(x, y)[c] = std::uint8_t(x * 3 + y * 50 + c * 20);
  for (const Format &format :
       {kRgba8, kBgra8, kRgb8, kLuminance8, kAlpha8, kRgba32f, kRgba16f, kRgba16}) {
    Image to = makeImage(format, 100, 10, 1, true);
    const float grey[4] = {0.5f, 0.5f, 0.5f, 0.5f};
    fill(to, {0, 0, 100, 10}, grey);
    copyPixels(to, 7, 4, 0, from, {2, 1, 68, 2});
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 68; ++x) {
        float source[1][4], got[1][4];
        unpackPixels(kRgba8, from.pixel(x + 2, y + 1), 1, source);
        unpackPixels(format, to.pixel(x + 7, y + 4), 1, got);
        for (int c = 0; c < 4; ++c) {
          const From origin = format.swizzle[std::size_t(c)];
          if (origin == From::Zero || origin == From::One)
            continue;
          // Luminance is stored from red.
          const float expected = source[0][sourceOf(format.swizzle, int(origin))];
          ASSERT_NEAR(got[0][c], expected, format.layout == Layout::F16x4 ? 0x1p-11 : 1e-7)
              << int(format.layout) << " at " << x << ", " << y << " component " << c;
        }
      }
    }
    float outside[1][4];
    unpackPixels(format, to.pixel(6, 4), 1, outside);
    EXPECT_NEAR(outside[0][3] == 1 ? outside[0][0] : outside[0][3], 0.5, 0.005)
        << "beside the copy";
  }
}

TEST(Image, TheSpareByteBecomesOne) {
  Image from = makeImage(kRgba8, 4, 1), to = makeImage(kRgb8, 4, 1);
  const float clear[4] = {};
  fill(from, {0, 0, 4, 1}, clear);
  copyPixels(to, 0, 0, 0, from, {0, 0, 4, 1});
  EXPECT_EQ(bytesAt(to, 3, 0), (std::vector<int>{0, 0, 0, 255}));
  fill(to, {0, 0, 4, 1}, clear);
  EXPECT_EQ(bytesAt(to, 0, 0), (std::vector<int>{0, 0, 0, 255}));
}

TEST(Image, FillsKeepWhatTheMaskLeavesOut) {
  Image image = makeImage(kBgra8, 130, 4);
  const float first[4] = {1, 1, 1, 1}, second[4] = {0, 0.25f, 0, 0};
  fill(image, {0, 0, 130, 4}, first);
  fill(image, {1, 1, 128, 2}, second, 0xB); // all components but blue
  EXPECT_EQ(bytesAt(image, 1, 1), (std::vector<int>{255, 64, 0, 0}));
  EXPECT_EQ(bytesAt(image, 128, 2), (std::vector<int>{255, 64, 0, 0}));
  for (const auto &[x, y] : {std::pair(0, 1), {129, 1}, {1, 0}, {1, 3}})
    EXPECT_EQ(bytesAt(image, x, y), (std::vector<int>{255, 255, 255, 255}));
}

TEST(Image, BytesAreRoundedAsHostsRoundThem) {
  // 0.7 times 255 is a little less than 178.5, and 0.3 times 255 is a little more than 76.5.
  Image image = makeImage(kRgba8, 4, 4);
  const float color[4] = {0.7f, 0.3f, 0.5f, 0.1f};
  fill(image, {0, 0, 4, 4}, color);
  EXPECT_EQ(bytesAt(image, 1, 1), (std::vector<int>{178, 76, 128, 26}));
}

TEST(Image, FloatFillsAreNotClamped) {
  Image image = makeImage(kRgba32f, 2, 2);
  const float value[4] = {-3, 7, 0.5f, 1e20f};
  fill(image, {0, 0, 2, 2}, value);
  float got[1][4];
  unpackPixels(kRgba32f, image.pixel(1, 1), 1, got);
  EXPECT_EQ(std::memcmp(got, value, sizeof value), 0);
}

TEST(Image, DepthAndStencilFills) {
  Image image = makeImage({Layout::Depth24Stencil8, abi::kRgba}, 5, 5);
  fillDepthStencil(image, {0, 0, 5, 5}, true, 1.0f, 0xFF, 0xA5);
  fillDepthStencil(image, {1, 1, 3, 3}, true, 0.5f, 0x0F, 0x00);
  const auto at = [&](int x, int y) {
    std::uint32_t value = 0;
    std::memcpy(&value, image.pixel(x, y), 4);
    return value;
  };
  EXPECT_EQ(at(0, 0), 0xFFFFFFA5u);
  EXPECT_EQ(at(1, 1), 0x800000A0u);
  fillDepthStencil(image, {1, 1, 3, 3}, false, 0, 0xFF, 0x11);
  EXPECT_EQ(at(3, 3), 0x80000011u);
  // 0.3 is 5033164.5 steps as a double or as a product of floats, but 5033164.7 if the float is
  // widened to a double.
  fillDepthStencil(image, {0, 0, 5, 5}, true, 0.3, 0, 0);
  EXPECT_EQ(at(0, 0) >> 8, 5033164u);
  fillDepthStencil(image, {0, 0, 5, 5}, true, 1, 0, 0);
  fillDepthStencil(image, {1, 1, 3, 3}, true, 0.3, 0, 0);
  EXPECT_EQ(at(1, 1) >> 8, 5033164u);
  Image depth16 = makeImage({Layout::Depth16, abi::kRgba}, 3, 3);
  fillDepthStencil(depth16, {0, 0, 3, 3}, true, 2.0f, 0, 0);
  EXPECT_EQ(bytesAt(depth16, 2, 2), (std::vector<int>{255, 255}));
  Image depth32 = makeImage({Layout::Depth32, abi::kRgba}, 3, 3);
  fillDepthStencil(depth32, {0, 0, 3, 3}, true, 1.0f, 0xFF, 0);
  EXPECT_EQ(bytesAt(depth32, 1, 1), (std::vector<int>{255, 255, 255, 255}));
  fillDepthStencil(depth32, {0, 0, 3, 3}, true, 0.25f, 0, 0);
  EXPECT_EQ(bytesAt(depth32, 2, 2), (std::vector<int>{0, 0, 0, 0x40}));
}

} // namespace
} // namespace arbiter::swrast
