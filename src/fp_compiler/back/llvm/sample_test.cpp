#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/cpu.h"
#include "fp_compiler/back/llvm/testing/guarded_texture.h"
#include "fp_compiler/back/llvm/testing/reference_sampler.h"
#include "fp_compiler/back/llvm/testing/sample_cases.h"
#include "fp_compiler/back/llvm/testing/sample_harness.h"

/// Generated sampling code against the reference, over pairs of everything that a sampler has; and
/// texture memory that ends where abi.h says it may.
namespace arbiter::fp::llvm_back::testing {
namespace {

constexpr std::uint32_t kChunks = 12;

/// Pixels of a call and what came back.
struct Pixels {
  explicit Pixels(int lanes) : count(int(kChunks) * lanes) {
    for (auto &plane : coordinate)
      plane.resize(std::size_t(count));
    for (auto &plane : result)
      plane.resize(std::size_t(count));
    bias.resize(std::size_t(count));
    packed.resize(std::size_t(count));
  }
  SampleCall call(const abi::TextureView &view) {
    SampleCall call;
    call.view = &view;
    for (std::size_t i = 0; i < 3; ++i)
      call.coordinate[i] = coordinate[i].data();
    for (std::size_t i = 0; i < 4; ++i)
      call.result[i] = result[i].data();
    call.bias = bias.data();
    call.packed = packed.data();
    return call;
  }
  int count;
  std::array<std::vector<float>, 3> coordinate;
  std::array<std::vector<float>, 4> result;
  std::vector<float> bias;
  std::vector<std::uint32_t> packed;
};

float uniform(std::mt19937 &random, float low, float high) {
  return std::uniform_real_distribution<float>(low, high)(random);
}

/// Chunk 0 and so on: lines of several steepnesses, exact texel centres, scattered points.
void fillCoordinates(const Case &test, int lanes, Pixels &pixels, std::mt19937 &random,
                     SampleCall &call) {
  const bool rect = test.key.dimension == abi::Dimension::Rect;
  const auto &size = test.size;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float texel = rect ? 1.0f : 1.0f / float(size[axis]);
    for (std::uint32_t chunk = 0; chunk < kChunks; ++chunk) {
      const float start = uniform(random, -1.5f, 2.5f) / (texel * float(size[axis]));
      const float slopes[] = {0, 1, -1, 0.37f, -2.7f, 1};
      float slope = slopes[(chunk + axis * (1 + chunk / 6)) % 6] * texel;
      if (axis > 0 && chunk % 2 == 0)
        slope = 0;
      for (int lane = 0; lane < lanes; ++lane) {
        const std::size_t at = chunk * std::uint32_t(lanes) + std::uint32_t(lane);
        float &value = pixels.coordinate[axis][at];
        if (chunk % 4 == 3)
          value = uniform(random, -1.5f, 2.5f) / (texel * float(size[axis]));
        else if (chunk % 4 == 2) // texel centres
          value = (std::floor(start / texel) + 0.5f) * texel + slope * float(lane);
        else
          value = start + slope * float(lane);
      }
    }
  }
  if (test.key.shadow)
    for (float &r : pixels.coordinate[2])
      r = random() % 4 == 0 ? float(random() % 2) : uniform(random, -0.2f, 1.2f);
  for (float &bias : pixels.bias)
    bias = uniform(random, -2, 3);
  // A level of detail that is one of many, for all pixels of a row.
  const float scale = std::exp2(uniform(random, -1.5f, 4.0f));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float texel = rect ? 1.0f : 1.0f / float(size[axis]);
    call.dx[axis] = scale * texel * uniform(random, -1, 1);
    call.dy[axis] = scale * texel * uniform(random, -1, 1);
  }
}

/// Lane of a quad's corner: of the block that `lane` is in.
int corner(const Cpu &cpu, int lane, int dx, int dy) {
  const int width = cpu.blockWidth();
  const int x = lane % width / 2 * 2 + dx, y = lane / width / 2 * 2 + dy;
  return y * width + x;
}

ReferenceQuery queryAt(const Case &test, const Cpu &cpu, const Pixels &pixels,
                       const SampleCall &call, int pixel) {
  ReferenceQuery query;
  const int lanes = cpu.lanes(), first = pixel / lanes * lanes;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &plane = pixels.coordinate[i];
    query.coordinate[i] = double(plane[std::size_t(pixel)]);
    if (test.options.lanes == abi::Lanes::Quad) {
      const auto at = [&](int dx, int dy) {
        return double(plane[std::size_t(first + corner(cpu, pixel - first, dx, dy))]);
      };
      query.dx[i] = at(1, 0) - at(0, 0);
      query.dy[i] = at(0, 1) - at(0, 0);
    } else {
      query.dx[i] = double(call.dx[i]);
      query.dy[i] = double(call.dy[i]);
    }
  }
  query.hasDerivatives = test.options.lanes == abi::Lanes::Quad || test.options.derivatives;
  query.bias = test.options.bias ? double(pixels.bias[std::size_t(pixel)]) : 0;
  return query;
}

struct Range {
  Color low, high;
};
/// What results can be had by roundings of the coordinates and of the level of detail.
Range rangeOf(const Case &test, const abi::TextureView &view, const ReferenceQuery &query) {
  Range range;
  range.low.fill(std::numeric_limits<double>::infinity());
  range.high.fill(-std::numeric_limits<double>::infinity());
  for (int choice = 0; choice < 81; ++choice) {
    ReferenceQuery moved = query;
    int rest = choice;
    for (std::size_t i = 0; i < 3; ++i, rest /= 3)
      if (!test.key.shadow || i < 2)
        moved.coordinate[i] += (rest % 3 - 1) * (std::fabs(query.coordinate[i]) + 1) * 0x1p-21;
    moved.lambdaOffset = (rest - 1) * 1e-4;
    if (moved.lambdaOffset != 0 && test.key.mip == abi::MipFilter::None &&
        test.key.magnify == test.key.minify)
      continue;
    const Color color = referenceSample(test.key, view, moved);
    for (std::size_t i = 0; i < 4; ++i) {
      range.low[i] = std::min(range.low[i], color[i]);
      range.high[i] = std::max(range.high[i], color[i]);
    }
  }
  return range;
}

class Sample : public ::testing::TestWithParam<const char *> {
protected:
  std::optional<Cpu> m_cpu;
  void SetUp() override {
    m_cpu = chooseCpu(GetParam());
    if (!m_cpu)
      GTEST_SKIP() << "this processor does not run code for " << GetParam();
  }
  void check(const Case &test, std::mt19937 &random) {
    SCOPED_TRACE(describe(test));
    std::string reason;
    const auto function = SampleFunction::make(*m_cpu, test.key, test.options, reason);
    ASSERT_TRUE(function) << reason;
    GuardedTexture texture(test.key, test.size, random);
    if (test.key.hasBias) {
      texture.view.lodBias = uniform(random, -3, 3);
      texture.view.minLod = uniform(random, -2, 2);
      texture.view.maxLod = uniform(random, 2, 5);
    }
    Pixels pixels(m_cpu->lanes());
    SampleCall call = pixels.call(texture.view);
    fillCoordinates(test, m_cpu->lanes(), pixels, random, call);
    (*function)(call, kChunks);
    compare(test, texture.view, pixels, call, function->hasPacked());
    checkWild(*function, pixels, call, random);
  }

private:
  void compare(const Case &test, const abi::TextureView &view, const Pixels &pixels,
               const SampleCall &call, bool packed) {
    for (int pixel = 0; pixel < pixels.count; ++pixel) {
      const ReferenceQuery query = queryAt(test, *m_cpu, pixels, call, pixel);
      const Range range = rangeOf(test, view, query);
      for (std::size_t i = 0; i < 4; ++i) {
        if (!(test.options.needed >> i & 1))
          continue;
        const double value = double(pixels.result[i][std::size_t(pixel)]);
        const double tolerance = 1e-3;
        ASSERT_TRUE(value >= range.low[i] - tolerance && value <= range.high[i] + tolerance)
            << "pixel " << pixel << " component " << i << " at (" << query.coordinate[0] << ", "
            << query.coordinate[1] << ", " << query.coordinate[2] << "): " << value
            << " is not in [" << range.low[i] << ", " << range.high[i] << "]";
      }
      if (!packed)
        continue;
      const auto *const bytes =
          reinterpret_cast<const std::uint8_t *>(&pixels.packed[std::size_t(pixel)]);
      const Color raw = referenceTexel(test.key.format, bytes);
      for (std::size_t i = 0; i < 4; ++i) {
        if (test.options.needed >> i & 1) {
          // A filtered texel is rounded to its bytes.
          const bool filtered =
              test.key.magnify == abi::Filter::Linear || test.key.minify == abi::Filter::Linear;
          ASSERT_NEAR(raw[i], double(pixels.result[i][std::size_t(pixel)]),
                      filtered ? 0.5001 / 255 : 1e-6)
              << "packed";
        }
      }
    }
  }
  /// No coordinate leads outside: the guard pages are the judges.
  void checkWild(const SampleFunction &function, Pixels &pixels, const SampleCall &call,
                 std::mt19937 &random) {
    const float kWild[] = {
        std::nanf(""),  HUGE_VALF, -HUGE_VALF,  3e38f,      -3e38f,  2147483648.0f,
        -2147483648.0f, 1e10f,     -1e10f,      8388607.5f, -1e-30f, 0,
        -0.0f,          1,         0.99999994f, -1};
    for (auto &plane : pixels.coordinate)
      for (float &value : plane)
        value = random() % 3 ? kWild[random() % std::size(kWild)] : uniform(random, -4, 4);
    for (float &bias : pixels.bias)
      bias = kWild[random() % std::size(kWild)];
    function(call, kChunks);
  }
};

TEST_P(Sample, PairsOfEverything) {
  std::mt19937 random(20041);
  for (const Case &test : pairwiseCases(random)) {
    if (test.key.mip != abi::MipFilter::None || test.key.magnify != test.key.minify ||
        test.key.shadow || test.key.dimension == abi::Dimension::Cube)
      check(test, random);
    if (HasFatalFailure())
      return;
  }
}

/// A key of the simplest kind.
abi::SamplerKey plainKey(abi::Filter filter) {
  abi::SamplerKey key;
  key.format.layout = abi::Layout::U8x4;
  key.magnify = key.minify = filter;
  return key;
}

// A map of texels to pixels gives the very texels: through a nearest filter, through a linear one
// in rows and in quads, and loaded as consecutive ones.
TEST_P(Sample, OneToOneIsExactWhicheverWay) {
  std::mt19937 random(7);
  for (const int width : {16, 64, 100, 333, 640, 1024}) {
    for (const abi::Wrap wrap :
         {abi::Wrap::Repeat, abi::Wrap::ClampToEdge, abi::Wrap::MirroredRepeat}) {
      abi::SamplerKey nearest = plainKey(abi::Filter::Nearest);
      nearest.wrap.fill(wrap);
      nearest.powerOfTwo = (width & (width - 1)) == 0;
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
            // A size that is no power of two makes coordinates that are a little off.
            if (nearest.powerOfTwo || key.magnify == abi::Filter::Nearest) {
              ASSERT_EQ(have, want) << where << " pixel " << i;
            }
            ASSERT_EQ(std::lround(have * 255), std::lround(want * 255)) << where << " pixel " << i;
          }
      }
    }
  }
}

// The same coordinates give the same bits in rows, which look for neighbours, and in quads.
TEST_P(Sample, RowsAndQuadsAgree) {
  std::mt19937 random(8);
  for (const Case &any : pairwiseCases(random)) {
    Case test = any;
    if (test.key.mip != abi::MipFilter::None || test.key.magnify != test.key.minify)
      continue; // derivatives of a row are others
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

// A filtered texel as it is stored: each component rounded to the nearest byte.
TEST_P(Sample, FilteredTexelIsRoundedToBytes) {
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
        ASSERT_NEAR(bytes[at], double(pixels.result[c][i]) * 255, 0.5001) << "pixel " << i;
      }
    }
  }
}

// 3.8.8: the texture's, the unit's and the program's biases are summed, and the sum is clamped.
TEST_P(Sample, BiasIsClampedAsASum) {
  std::mt19937 random(11);
  abi::SamplerKey key = plainKey(abi::Filter::Nearest);
  key.mip = abi::MipFilter::Nearest;
  key.hasBias = key.powerOfTwo = 1;
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

// Texels know their place: a big texture is addressed right to its last texel.
TEST_P(Sample, ReachesAllOfABigTexture) {
  constexpr int kSize = 4096;
  const std::size_t bytes = std::size_t(kSize) * kSize * 4;
  const GuardedMemory memory(bytes, true);
  for (std::uint32_t i = 0; i < kSize * kSize; ++i)
    std::memcpy(memory.data() + std::size_t(i) * 4, &i, 4);
  const abi::TextureLevel level = {memory.data(), kSize * 4, 0, kSize, kSize, 1};
  const abi::TextureView view = {&level, 1};
  abi::SamplerKey key = plainKey(abi::Filter::Nearest);
  key.powerOfTwo = 1;
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

INSTANTIATE_TEST_SUITE_P(Cpus, Sample, ::testing::Values("", "avx512", "avx2", "sse4"));

} // namespace
} // namespace arbiter::fp::llvm_back::testing
