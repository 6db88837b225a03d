#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/code/cpu.h"
#include "fp_compiler/back/llvm/testing/guarded_texture.h"
#include "fp_compiler/back/llvm/testing/sample_pixels.h"

/// Tests exact results of generated sampling code, and single rules of the specification.
namespace arbiter::fp::llvm_back::testing {
namespace {

class Sample : public ::testing::TestWithParam<const char *> {
protected:
  void SetUp() override {
    m_cpu = chooseCpu(GetParam());
    if (!m_cpu)
      GTEST_SKIP() << "this processor does not run code for " << GetParam();
  }
  std::optional<Cpu> m_cpu;
};

/// Returns a key of the simplest kind.
abi::SamplerKey plainKey(abi::Filter filter) {
  abi::SamplerKey key;
  key.format.layout = abi::Layout::U8x4;
  key.magnify = key.minify = filter;
  return key;
}

// A 1:1 mapping gives exactly the texels. This holds for a nearest filter, for a linear one in rows
// and quads, and for consecutive loads.
TEST_P(Sample, OneToOneIsExactWhicheverWay) {
  std::mt19937 random(7);
  for (const int width : {16, 64, 100, 333, 640, 1024}) {
    for (const abi::Wrap wrap :
         {abi::Wrap::Repeat, abi::Wrap::ClampToEdge, abi::Wrap::MirroredRepeat}) {
      abi::SamplerKey nearest = plainKey(abi::Filter::Nearest);
      nearest.wrap.fill(wrap);
      nearest.powerOfTwo = (width & (width - 1)) == 0 ? 7 : 0;
      abi::SamplerKey linear = nearest;
      linear.magnify = linear.minify = abi::Filter::Linear;
      SampleOptions row, quad, texels;
      quad.lanes = abi::Lanes::Quad;
      texels.texels = true;
      GuardedTexture texture(nearest, {width, nearest.powerOfTwo ? 4 : 3, 1}, random);
      Pixels loaded(m_cpu->lanes()), pixels(m_cpu->lanes());
      const abi::TextureLevel &level = texture.view.levels[0];
      const int count = std::min(width, loaded.count) / m_cpu->lanes();
      for (int i = 0; i < loaded.count; ++i) {
        pixels.coordinate[0][std::size_t(i)] = (float(i) + 0.5f) / float(width);
        pixels.coordinate[1][std::size_t(i)] = 1.5f / float(level.height);
      }
      std::string reason;
      SampleCall call = loaded.call(texture.view);
      call.texels = level.base + level.rowStride;
      const auto plain = SampleFunction::make(*m_cpu, nearest, texels, reason);
      ASSERT_TRUE(plain && plain->hasPacked()) << reason;
      (*plain)(call, std::uint32_t(count));
      for (const auto &[key, options] : {std::pair{nearest, row}, {linear, row}, {linear, quad}}) {
        const auto function = SampleFunction::make(*m_cpu, key, options, reason);
        ASSERT_TRUE(function) << reason;
        (*function)(pixels.call(texture.view), std::uint32_t(count));
        for (int i = 0; i < count * m_cpu->lanes(); ++i)
          for (std::size_t c = 0; c < 4; ++c) {
            const float want = loaded.result[c][std::size_t(i)];
            const float have = pixels.result[c][std::size_t(i)];
            const std::string where = describe({key, options, {width, level.height, 1}});
            // With a size that is no power of two, coordinates have small errors.
            if (nearest.powerOfTwo || key.magnify == abi::Filter::Nearest) {
              ASSERT_EQ(have, want) << where << " pixel " << i;
            }
            ASSERT_EQ(std::lround(have * 255), std::lround(want * 255)) << where << " pixel " << i;
          }
      }
    }
  }
}

// Masked lanes neither change others nor prolong a loop. In a cube map's quads, each lane has
// derivatives that the others need.
TEST_P(Sample, MaskedLanesDoNotMatter) {
  for (const auto dimension : {abi::Dimension::Tex2D, abi::Dimension::Cube}) {
    std::mt19937 random(12);
    abi::SamplerKey key = plainKey(abi::Filter::Linear);
    key.dimension = dimension;
    key.mip = abi::MipFilter::Linear;
    SampleOptions plain, masked;
    plain.lanes = masked.lanes = abi::Lanes::Quad;
    plain.bias = masked.bias = masked.mask = true;
    GuardedTexture texture(key, {32, 32, 1}, random);
    std::string reason;
    const auto all = SampleFunction::make(*m_cpu, key, plain, reason);
    const auto some = SampleFunction::make(*m_cpu, key, masked, reason);
    ASSERT_TRUE(all && some) << reason;
    Pixels pixels(m_cpu->lanes()), holes(m_cpu->lanes());
    for (auto &plane : pixels.coordinate)
      for (float &value : plane)
        value = uniform(random, -1, 1);
    for (float &bias : pixels.bias)
      bias = uniform(random, -8, 2);
    holes.coordinate = pixels.coordinate;
    holes.bias = pixels.bias;
    std::vector<bool> counts;
    int left = 0;
    for (int i = 0; i < holes.count; ++i) {
      const int lane = i % m_cpu->lanes(), width = m_cpu->blockWidth();
      const int x = lane % width, y = lane / width;
      // Pixels that a quad's derivatives need stay unmasked. For cube maps that is the whole quad.
      if (dimension == abi::Dimension::Cube)
        counts.push_back((x / 2 + y / 2 + i / m_cpu->lanes()) % 2 == 0);
      else
        counts.push_back(random() % 2 || (x % 2 && y % 2 == 0) || x % 2 == 0);
      left += counts.back() ? 1 : 0;
      if (!counts.back())
        holes.coordinate[0][std::size_t(i)] = std::nanf("");
    }
    ASSERT_GT(left, 0);
    ASSERT_LT(left, holes.count);
    (*all)(pixels.call(texture.view), kChunks);
    (*some)(holes.call(texture.view), kChunks);
    for (std::size_t i = 0; i < counts.size(); ++i)
      for (std::size_t c = 0; c < 4 && counts[i]; ++c)
        ASSERT_EQ(pixels.result[c][i], holes.result[c][i]) << "pixel " << i;
    std::fill(holes.coordinate[0].begin(), holes.coordinate[0].end(), std::nanf(""));
    (*some)(holes.call(texture.view), kChunks);
  }
}

// The same coordinates give the same bits in rows, which look for neighbours, and in quads.
TEST_P(Sample, RowsAndQuadsAgree) {
  std::mt19937 random(8);
  for (const Case &any : pairwiseCases(random)) {
    Case test = any;
    if (test.key.mip != abi::MipFilter::None || test.key.magnify != test.key.minify)
      continue; // a row's derivatives differ
    GuardedTexture texture(test.key, test.size, random);
    Pixels row(m_cpu->lanes()), quad(m_cpu->lanes());
    SampleCall call = row.call(texture.view);
    fillCoordinates(test, m_cpu->lanes(), row, random, call);
    quad.coordinate = row.coordinate;
    for (Pixels *const pixels : {&row, &quad}) {
      test.options.lanes = pixels == &row ? abi::Lanes::Row : abi::Lanes::Quad;
      test.options.derivatives = false;
      std::string reason;
      const auto function = SampleFunction::make(*m_cpu, test.key, test.options, reason);
      ASSERT_TRUE(function) << reason;
      (*function)(pixels->call(texture.view), kChunks);
    }
    for (std::size_t c = 0; c < 4; ++c)
      ASSERT_EQ(row.result[c], quad.result[c]) << describe(test);
  }
}

// A filtered texel has byte components and is stored unchanged.
TEST_P(Sample, FilteredTexelIsBytes) {
  std::mt19937 random(10);
  for (const abi::Wrap wrap : {abi::Wrap::Repeat, abi::Wrap::ClampToEdge}) {
    abi::SamplerKey key = plainKey(abi::Filter::Linear);
    key.format.swizzle = {abi::From::C2, abi::From::C1, abi::From::C0, abi::From::C3};
    key.wrap.fill(wrap);
    GuardedTexture texture(key, {24, 10, 1}, random);
    std::string reason;
    const auto function = SampleFunction::make(*m_cpu, key, {}, reason);
    ASSERT_TRUE(function) << reason;
    ASSERT_TRUE(function->hasPacked());
    Pixels pixels(m_cpu->lanes());
    for (auto &plane : pixels.coordinate)
      for (float &value : plane)
        value = uniform(random, -1, 2);
    (*function)(pixels.call(texture.view), kChunks);
    for (std::size_t i = 0; i < std::size_t(pixels.count); ++i) {
      const auto *const bytes = reinterpret_cast<const std::uint8_t *>(&pixels.packed[i]);
      for (std::size_t c = 0; c < 4; ++c) {
        const int at = c == 3 ? 3 : 2 - int(c);
        ASSERT_EQ(float(bytes[at]) * (1.0f / 255.0f), pixels.result[c][i]) << "pixel " << i;
      }
    }
  }
}

// The biases of texture, unit and program are summed, and the sum is clamped (3.8.8).
TEST_P(Sample, BiasIsClampedAsASum) {
  std::mt19937 random(11);
  abi::SamplerKey key = plainKey(abi::Filter::Nearest);
  key.mip = abi::MipFilter::Nearest;
  key.hasBias = 1;
  key.powerOfTwo = 7;
  GuardedTexture texture(key, {64, 64, 1}, random);
  SampleOptions options;
  options.derivatives = options.bias = true;
  std::string reason;
  const auto function = SampleFunction::make(*m_cpu, key, options, reason);
  ASSERT_TRUE(function) << reason;
  struct {
    float texture, program;
    int level;
  } const kCases[] = {{-30, -10, 2}, {-30, 14, 2}, {-14, 0, 4}, {-18, 2.9f, 3}, {30, -46.8f, 2}};
  for (const auto &[ofTexture, ofProgram, level] : kCases) {
    texture.view.lodBias = ofTexture;
    Pixels pixels(m_cpu->lanes());
    std::fill(pixels.bias.begin(), pixels.bias.end(), ofProgram);
    SampleCall call = pixels.call(texture.view);
    call.dx[0] = 0x1p18f / 64; // 18 levels
    (*function)(call, 1);
    const std::uint8_t *const texel = texture.view.levels[level].base;
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_EQ(std::lround(pixels.result[c][0] * 255), texel[c])
          << ofTexture << " and " << ofProgram << " component " << c;
  }
}

// A big texture is addressed correctly up to its last texel.
TEST_P(Sample, ReachesAllOfABigTexture) {
  constexpr int kSize = 4096;
  const std::size_t bytes = std::size_t(kSize) * kSize * 4;
  const GuardedMemory memory(bytes, true);
  for (std::uint32_t i = 0; i < kSize * kSize; ++i)
    std::memcpy(memory.data() + std::size_t(i) * 4, &i, 4);
  const abi::TextureLevel level = {memory.data(), kSize * 4, 0, kSize, kSize, 1};
  const abi::TextureView view = {&level, 1};
  abi::SamplerKey key = plainKey(abi::Filter::Nearest);
  key.powerOfTwo = 7;
  std::string reason;
  const auto function = SampleFunction::make(*m_cpu, key, {}, reason);
  ASSERT_TRUE(function) << reason;
  Pixels pixels(m_cpu->lanes());
  std::mt19937 random(9);
  std::vector<std::uint32_t> want;
  for (int i = 0; i < pixels.count; ++i) {
    const std::uint32_t x = i % 5 ? random() % kSize : kSize - 1,
                        y = i % 5 ? random() % kSize : kSize - 1;
    want.push_back(y * kSize + x);
    pixels.coordinate[0][std::size_t(i)] = (float(x) + 0.5f) / kSize;
    pixels.coordinate[1][std::size_t(i)] = (float(y) + 0.5f) / kSize;
  }
  (*function)(pixels.call(view), kChunks);
  EXPECT_EQ(pixels.packed, want);
}

// Tests each sRGB byte in a sampled texel and in a row of consecutive texels. Alpha is linear.
// White and black do not change.
TEST_P(Sample, SrgbIsDecoded) {
  constexpr int kWidth = 256;
  const GuardedMemory memory(kWidth * 4, true);
  for (int i = 0; i < kWidth; ++i)
    std::memset(memory.data() + std::ptrdiff_t(i) * 4, i, 4);
  const abi::TextureLevel level = {memory.data(), kWidth * 4, 0, kWidth, 1, 1};
  const abi::TextureView view = {&level, 1};
  abi::SamplerKey key = plainKey(abi::Filter::Nearest);
  key.format.srgb = 7;
  SampleOptions loaded;
  loaded.texels = true;
  for (const SampleOptions &options : {SampleOptions{}, loaded}) {
    std::string reason;
    const auto function = SampleFunction::make(*m_cpu, key, options, reason);
    ASSERT_TRUE(function) << reason;
    EXPECT_FALSE(function->hasPacked()) << "the bytes are not the texel";
    Pixels pixels(m_cpu->lanes());
    for (int first = 0; first + m_cpu->lanes() <= kWidth; first += m_cpu->lanes()) {
      SampleCall call = pixels.call(view);
      call.texels = memory.data() + std::ptrdiff_t(first) * 4;
      for (int i = 0; i < m_cpu->lanes(); ++i)
        pixels.coordinate[0][std::size_t(i)] = (float(first + i) + 0.5f) / kWidth;
      (*function)(call, 1);
      for (int i = 0; i < m_cpu->lanes(); ++i) {
        const double byte = (first + i) / 255.0;
        const double want = byte <= 0.04045 ? byte / 12.92 : std::pow((byte + 0.055) / 1.055, 2.4);
        for (std::size_t c = 0; c < 4; ++c)
          ASSERT_NEAR(double(pixels.result[c][std::size_t(i)]), c == 3 ? byte : want, 2e-6)
              << "byte " << first + i << " component " << c;
      }
    }
    EXPECT_EQ(pixels.result[0][std::size_t(m_cpu->lanes()) - 1], 1.0f);
  }
}

// If components are equal in size, z comes before y, and y before x. The sign, even of a zero,
// selects the side. A zero direction gives the middle texel. Images of all such directions on Mesa
// 22.3.6 show this; table 3.21 leaves it open.
TEST_P(Sample, TiesOfACubeMapsAxes) {
  constexpr int kFaces = 6, kEdge = 3, kPad = 64;
  abi::SamplerKey key = plainKey(abi::Filter::Nearest);
  key.dimension = abi::Dimension::Cube;
  std::vector<std::uint8_t> bytes(2 * kPad + kFaces * kEdge * kEdge * 4);
  abi::TextureLevel levels[kFaces];
  for (int face = 0; face < kFaces; ++face) {
    levels[face].base = bytes.data() + kPad + std::ptrdiff_t(face) * kEdge * kEdge * 4;
    levels[face].rowStride = kEdge * 4;
    levels[face].width = levels[face].height = kEdge;
    levels[face].depth = 1;
    for (int i = 0; i < kEdge * kEdge; ++i) {
      const std::size_t texel = std::size_t(kPad + (face * kEdge * kEdge + i) * 4);
      bytes[texel] = std::uint8_t(face);
      bytes[texel + 1] = std::uint8_t(i);
    }
  }
  abi::TextureView view;
  view.levels = levels;
  view.levelCount = 1;
  std::string reason;
  const auto function = SampleFunction::make(*m_cpu, key, {}, reason);
  ASSERT_TRUE(function) << reason;
  for (const float x : {-1.0f, -0.5f, -0.0f, 0.0f, 0.5f, 1.0f})
    for (const float y : {-1.0f, -0.5f, -0.0f, 0.0f, 0.5f, 1.0f})
      for (const float z : {-1.0f, -0.5f, -0.0f, 0.0f, 0.5f, 1.0f}) {
        const float direction[3] = {x, y, z};
        Pixels pixels(m_cpu->lanes());
        for (std::size_t c = 0; c < 3; ++c)
          std::fill(pixels.coordinate[c].begin(), pixels.coordinate[c].end(), direction[c]);
        (*function)(pixels.call(view), 1);
        const float sizes[3] = {std::fabs(x), std::fabs(y), std::fabs(z)};
        int axis = 0;
        for (int other = 1; other < 3; ++other)
          axis = sizes[other] >= sizes[axis] ? other : axis;
        const int face = 2 * axis + (std::signbit(direction[axis]) ? 1 : 0);
        ASSERT_EQ(std::lround(pixels.result[0][0] * 255), face) << x << ", " << y << ", " << z;
        if (sizes[axis] == 0) {
          ASSERT_EQ(std::lround(pixels.result[1][0] * 255), 4) << "the middle texel";
        }
      }
}

INSTANTIATE_TEST_SUITE_P(Cpus, Sample, ::testing::Values("", "avx512", "avx2", "sse4.1"));

} // namespace
} // namespace arbiter::fp::llvm_back::testing
