// Compares fetched vertices of every type with a plain reading of the conversion table, and tests
// indices.
#include "state/raster_draw/vertices/vertex_fetch.h"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include <GL/glext.h>
#include <gtest/gtest.h>

#include "state/raster_draw/vertices/vertex_convert.h"

namespace arbiter::state {
namespace {

struct TypeRow {
  GLenum type;
  int bits;
  bool isSigned, isInteger;
};
constexpr TypeRow kTypes[] = {
    {GL_BYTE, 8, true, true},         {GL_UNSIGNED_BYTE, 8, false, true},
    {GL_SHORT, 16, true, true},       {GL_UNSIGNED_SHORT, 16, false, true},
    {GL_INT, 32, true, true},         {GL_UNSIGNED_INT, 32, false, true},
    {GL_FLOAT, 32, true, false},      {GL_DOUBLE, 64, true, false},
    {GL_HALF_FLOAT, 16, true, false}, {GL_FIXED, 32, true, false},
};

/// Reads component `c` of an element bit by bit, in doubles.
double plainly(const TypeRow &row, const std::uint8_t *element, int c, bool normalized,
               bool symmetric) {
  const std::uint8_t *const at = element + c * row.bits / 8;
  if (row.type == GL_FLOAT || row.type == GL_DOUBLE) {
    float single = 0;
    double both = 0;
    std::memcpy(&single, at, sizeof single);
    if (row.type == GL_DOUBLE)
      std::memcpy(&both, at, sizeof both);
    return row.type == GL_FLOAT ? double(single) : double(float(both));
  }
  std::uint64_t raw = 0;
  std::memcpy(&raw, at, std::size_t(row.bits / 8));
  if (row.type == GL_HALF_FLOAT) {
    const int exponent = int(raw >> 10 & 31), mantissa = int(raw & 1023);
    const double size =
        exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
    return (raw & 0x8000u) != 0 ? -size : size;
  }
  double value = double(raw);
  if (row.isSigned && (raw >> (row.bits - 1)) != 0)
    value -= std::ldexp(1.0, row.bits);
  if (row.type == GL_FIXED)
    return value / 65536;
  if (!normalized)
    return value;
  if (!row.isSigned)
    return value / (std::ldexp(1.0, row.bits) - 1);
  if (symmetric)
    return std::max(value / (std::ldexp(1.0, row.bits - 1) - 1), -1.0);
  return (2 * value + 1) / (std::ldexp(1.0, row.bits) - 1);
}

/// Returns bytes that make finite floats, and the extremes of each integer type.
std::vector<std::uint8_t> bytesFor(const TypeRow &row, std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  std::uint32_t state = 12345;
  for (std::uint8_t &byte : bytes)
    byte = std::uint8_t((state = state * 1664525 + 1013904223) >> 24);
  if (row.isInteger) {
    std::fill_n(bytes.begin(), 32, std::uint8_t(0xFF)); // -1, or the largest number
    std::fill_n(bytes.begin() + 32, 32, std::uint8_t(0));
    for (std::size_t i = 0; i < 32; ++i)
      bytes[64 + i] = std::uint8_t((i + 1) % std::size_t(row.bits / 8) == 0 ? 0x80 : 0); // least
    return bytes;
  }
  if (row.type == GL_FIXED)
    return bytes;
  for (std::uint8_t &byte : bytes) // avoids NaN, infinity and denormals wherever a number begins
    byte = std::uint8_t((byte & 0x83u) | 0x38u);
  return bytes;
}

class EveryType : public ::testing::TestWithParam<int> {};

TEST_P(EveryType, IsWhatTheTableSays) {
  const TypeRow &row = kTypes[GetParam()];
  for (int components = 1; components <= 4; ++components)
    for (int kind = 0; kind < 4; ++kind) {
      const bool normalized = (kind & 1) != 0 && row.isInteger, symmetric = (kind & 2) != 0;
      VertexSource source;
      source.symmetric = symmetric;
      VertexSource::Array &array = source.arrays[kTexCoord0];
      array.type = row.type;
      array.components = std::uint8_t(components);
      array.normalized = normalized;
      const std::uint32_t element = elementBytes(array);
      ASSERT_EQ(element, std::uint32_t(components * row.bits / 8));
      array.stride = element + 3; // misaligned on purpose
      const std::vector<std::uint8_t> bytes = bytesFor(row, 200 * (element + 3) + 1);
      array.base = bytes.data() + 1;
      VertexFetcher fetcher;
      ASSERT_TRUE(fetcher.fetch(source, {}, 1u << kTexCoord0, 2, 70));
      for (int i = 0; i < 70; ++i)
        for (int c = 0; c < 4; ++c) {
          const float got = fetcher.component(kTexCoord0, c)[i];
          const double wanted =
              c < components ? plainly(row, bytes.data() + 1 + std::size_t(i + 2) * array.stride, c,
                                       normalized, symmetric)
                             : (c == 3 ? 1 : 0);
          ASSERT_NEAR(got, wanted, std::abs(wanted) * 1.3e-7)
              << "type " << std::hex << row.type << " component " << c << " of " << components
              << " vertex " << i;
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Types, EveryType, ::testing::Range(0, int(std::size(kTypes))));

TEST(VertexFetch, BgraAndPackedNumbers) {
  VertexSource source;
  const std::uint8_t bgra[8] = {0, 51, 102, 255, 255, 0, 0, 0};
  source.arrays[kColor] = {bgra, 4, GL_UNSIGNED_BYTE, 4, true, true};
  // The components are x = 1, y = -512, z = 511, w = -2, or unsigned 1, 512, 511, 2.
  const std::uint32_t packed = 1u | 512u << 10 | 511u << 20 | 2u << 30;
  source.arrays[kNormal] = {&packed, 4, GL_INT_2_10_10_10_REV, 4, false, false};
  source.arrays[kSecondary] = {&packed, 4, GL_UNSIGNED_INT_2_10_10_10_REV, 4, true, true};
  VertexFetcher fetcher;
  ASSERT_TRUE(fetcher.fetch(source, {}, 1u << kColor | 1u << kNormal | 1u << kSecondary, 0, 1));
  const auto vec = [&](int slot) {
    return std::array<float, 4>{fetcher.component(slot, 0)[0], fetcher.component(slot, 1)[0],
                                fetcher.component(slot, 2)[0], fetcher.component(slot, 3)[0]};
  };
  EXPECT_EQ(vec(kColor), (std::array<float, 4>{0.4f, 0.2f, 0.0f, 1.0f}));
  EXPECT_EQ(vec(kNormal), (std::array<float, 4>{1, -512, 511, -2}));
  const auto secondary = vec(kSecondary);
  EXPECT_FLOAT_EQ(secondary[2], 1 / 1023.0f);
  EXPECT_FLOAT_EQ(secondary[1], 512 / 1023.0f);
  EXPECT_FLOAT_EQ(secondary[0], 511 / 1023.0f);
  EXPECT_FLOAT_EQ(secondary[3], 2 / 3.0f);
}

TEST(VertexFetch, CurrentValuesFillArraysAndFollowChanges) {
  VertexFetcher fetcher;
  CurrentValues current{};
  current[kColor] = {0.25f, 0.5f, 0.75f, 1.0f};
  for (const std::uint32_t count : {3u, 1000u, 20u}) {
    ASSERT_TRUE(fetcher.fetch({}, current, 1u << kColor, 0, count));
    for (std::uint32_t i = 0; i < ((count + 15) & ~15u); ++i)
      ASSERT_EQ(fetcher.component(kColor, 1)[i], 0.5f) << i << " of " << count;
  }
  current[kColor][1] = -0.0f;
  ASSERT_TRUE(fetcher.fetch({}, current, 1u << kColor, 0, 17));
  EXPECT_TRUE(std::signbit(fetcher.component(kColor, 1)[31]));
  EXPECT_EQ(std::uintptr_t(fetcher.component(kColor, 0)) % 64, 0u);
}

TEST(VertexFetch, VerticesThatAreNotThereAreRefused) {
  const std::vector<float> data(40);
  VertexSource source;
  source.arrays[kPosition] = {data.data(), 16, GL_FLOAT, 4, false, false};
  source.count = 10;
  VertexFetcher fetcher;
  EXPECT_TRUE(fetcher.fetch(source, {}, 1, 0, 10));
  EXPECT_TRUE(fetcher.fetch(source, {}, 1, 10, 0));
  EXPECT_FALSE(fetcher.fetch(source, {}, 1, 0, 11));
  EXPECT_FALSE(fetcher.fetch(source, {}, 1, 5, 6));
  EXPECT_FALSE(fetcher.fetch(source, {}, 1, ~0u, 2));
  source.arrays[kPosition].type = GL_BITMAP;
  EXPECT_FALSE(fetcher.fetch(source, {}, 1, 0, 1));
}

TEST(VertexFetch, IndicesAreWidenedAndRebased) {
  const std::uint8_t bytes[] = {7, 9, 7, 200};
  const std::uint32_t words[] = {0xFFFFFFF0u, 0xFFFFFFF1u};
  std::uint8_t shorts[7] = {0};
  const std::uint16_t values[] = {300, 100, 65535};
  std::memcpy(shorts + 1, values, sizeof values); // misaligned on purpose
  VertexFetcher fetcher;
  IndexRange range;
  ASSERT_TRUE(fetcher.decodeIndices(GL_UNSIGNED_BYTE, bytes, 4, -5, range));
  EXPECT_EQ(range.minimum, 2u);
  EXPECT_EQ(range.maximum, 195u);
  EXPECT_EQ(range.indices[1], 2u);
  ASSERT_TRUE(fetcher.decodeIndices(GL_UNSIGNED_SHORT, shorts + 1, 3, 0, range));
  EXPECT_EQ(range.minimum, 100u);
  EXPECT_EQ(range.indices[2], 65435u);
  EXPECT_FALSE(fetcher.decodeIndices(GL_UNSIGNED_BYTE, bytes, 4, -8, range)) << "below zero";
  EXPECT_FALSE(fetcher.decodeIndices(GL_UNSIGNED_INT, words, 2, 100, range)) << "beyond 32 bits";
  EXPECT_FALSE(fetcher.decodeIndices(GL_FLOAT, words, 2, 0, range));
  EXPECT_TRUE(fetcher.decodeIndices(GL_UNSIGNED_INT, words, 0, 0, range));
}

TEST(VertexFetch, FewVerticesOfAWideRangeAreCopiedTogether) {
  std::vector<float> data(2 * 5000);
  for (std::size_t i = 0; i < data.size(); ++i)
    data[i] = float(i);
  VertexSource source;
  source.arrays[kPosition] = {data.data(), 8, GL_FLOAT, 2, false, false};
  source.arrays[kTexCoord0] = {data.data() + 1, 8, GL_FLOAT, 1, false, false};
  source.count = 5000;
  const std::uint16_t indices[] = {4900, 7, 4900, 2000};
  VertexFetcher fetcher;
  IndexRange range;
  const auto drawn = [&](std::uint32_t at) {
    const std::uint32_t i = range.indices[at];
    return std::array<float, 3>{fetcher.component(kPosition, 0)[i],
                                fetcher.component(kPosition, 1)[i],
                                fetcher.component(kTexCoord0, 0)[i]};
  };
  const std::uint32_t slots = 1u << kPosition | 1u << kTexCoord0 | 1u << kColor;
  for (const bool compacted : {false, true}) {
    VertexSource used = source;
    ASSERT_TRUE(fetcher.decodeIndices(GL_UNSIGNED_SHORT, indices, 4, 3, range));
    if (compacted) {
      ASSERT_TRUE(fetcher.compact(used, slots, range));
    }
    EXPECT_EQ(range.maximum - range.minimum + 1, compacted ? 4u : 4894u);
    ASSERT_TRUE(fetcher.fetch(used, {}, slots, range.minimum, range.maximum - range.minimum + 1));
    EXPECT_EQ(drawn(0), (std::array<float, 3>{9806, 9807, 9807}));
    EXPECT_EQ(drawn(1), (std::array<float, 3>{20, 21, 21}));
    EXPECT_EQ(drawn(2), drawn(0));
    EXPECT_EQ(drawn(3), (std::array<float, 3>{4006, 4007, 4007}));
  }
  ASSERT_TRUE(fetcher.decodeIndices(GL_UNSIGNED_SHORT, indices, 4, 200, range));
  EXPECT_FALSE(fetcher.compact(source, slots, range)) << "5100 of 5000";
}

TEST(VertexFetch, IsFastEnoughForScenes) {
  constexpr std::uint32_t kCount = 300000;
  const std::vector<float> positions(3 * kCount, 0.5f), coords(2 * kCount, 0.25f);
  VertexSource source;
  source.arrays[kPosition] = {positions.data(), 12, GL_FLOAT, 3, false, false};
  source.arrays[kTexCoord0] = {coords.data(), 8, GL_FLOAT, 2, false, false};
  VertexFetcher fetcher;
  double best = 1e9;
  for (int i = 0; i < 20; ++i) {
    const auto start = std::chrono::steady_clock::now();
    ASSERT_TRUE(fetcher.fetch(source, {}, 1u << kPosition | 1u << kTexCoord0, 0, kCount));
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - start;
    best = std::min(best, taken.count());
  }
  RecordProperty("milliseconds", std::to_string(best));
  std::printf("fetch of 300000 vertices: %.3f ms\n", best);
  // Sanitizers and debug builds are slower; this only catches a loop gone quadratic.
  EXPECT_LT(best, 200.0);
}

} // namespace
} // namespace arbiter::state
