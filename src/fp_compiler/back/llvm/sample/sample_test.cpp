#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/code/cpu.h"
#include "fp_compiler/back/llvm/testing/guarded_texture.h"
#include "fp_compiler/back/llvm/testing/reference_sampler.h"
#include "fp_compiler/back/llvm/testing/sample_pixels.h"

/// Compares generated sampling code with the reference, over pairs of all sampler properties. The
/// texture memory ends where abi.h allows it.
namespace arbiter::fp::llvm_back::testing {
namespace {

/// Returns the lane of a corner of the quad that contains `lane`.
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
      // A cube map's derivatives are those of the pixel's own row and column.
      const bool own = test.key.dimension == abi::Dimension::Cube;
      const int lane = pixel - first, width = cpu.blockWidth();
      const int x = own ? lane % width % 2 : 0, y = own ? lane / width % 2 : 0;
      query.dx[i] = at(1, y) - at(0, y);
      query.dy[i] = at(x, 1) - at(x, 0);
    } else {
      query.dx[i] = double(call.dx[i]);
      query.dy[i] = double(call.dy[i]);
    }
  }
  query.hasDerivatives = test.options.lanes == abi::Lanes::Quad || test.options.derivatives;
  if (test.options.lod)
    query.scale = std::exp2(double(pixels.bias[std::size_t(pixel)]));
  query.bias = test.options.bias && !test.options.lod ? double(pixels.bias[std::size_t(pixel)]) : 0;
  return query;
}

struct Range {
  Color low, high;
};
/// Returns the allowed rounding error of machine code's coordinate. With several samples, each
/// one's place is computed.
double rounding(const ReferenceQuery &query, std::size_t i) {
  const double moved = query.scale ? std::fabs(query.dx[i]) + std::fabs(query.dy[i]) : 0;
  return (std::fabs(query.coordinate[i]) + 1 + moved) * 0x1p-21;
}

/// Returns the range of results of one lookup under rounding errors of coordinates and level of
/// detail.
Range rangeOfLookup(const Case &test, const abi::TextureView &view, const ReferenceQuery &query) {
  Range range;
  range.low.fill(std::numeric_limits<double>::infinity());
  range.high.fill(-std::numeric_limits<double>::infinity());
  const int axes =
      test.key.dimension == abi::Dimension::Tex1D ? 1
      : test.key.dimension == abi::Dimension::Tex3D || test.key.dimension == abi::Dimension::Cube
          ? 3
          : 2;
  const bool hasLevels =
      test.key.mip != abi::MipFilter::None || test.key.magnify != test.key.minify;
  const int choices = (axes == 1 ? 3 : axes == 2 ? 9 : 27) * (hasLevels ? 3 : 1);
  for (int choice = 0; choice < choices; ++choice) {
    ReferenceQuery moved = query;
    int rest = choice;
    if (hasLevels) {
      moved.lambdaOffset = (rest % 3 - 1) * 1e-4;
      rest /= 3;
    }
    for (std::size_t i = 0; i < std::size_t(axes); ++i, rest /= 3)
      moved.coordinate[i] += (rest % 3 - 1) * rounding(query, i);
    const Color color = referenceSample(test.key, view, moved);
    for (std::size_t i = 0; i < 4; ++i) {
      range.low[i] = std::min(range.low[i], color[i]);
      range.high[i] = std::max(range.high[i], color[i]);
    }
  }
  return range;
}

/// Returns that range for a whole sample. An anisotropic filter's lookups round independently, and
/// their number may differ too.
Range rangeOf(const Case &test, const abi::TextureView &view, const ReferenceQuery &query) {
  Range whole;
  whole.low.fill(std::numeric_limits<double>::infinity());
  whole.high.fill(-std::numeric_limits<double>::infinity());
  std::size_t last = 0;
  for (const double offset : {-1e-4, 0.0, 1e-4}) {
    const auto lookups = referenceSamples(test.key, view, query, offset);
    if (lookups.size() == std::exchange(last, lookups.size()))
      continue;
    Range mean = {};
    for (const ReferenceQuery &lookup : lookups) {
      const Range range = rangeOfLookup(test, view, lookup);
      for (std::size_t i = 0; i < 4; ++i) {
        mean.low[i] += range.low[i] / double(lookups.size());
        mean.high[i] += range.high[i] / double(lookups.size());
      }
    }
    for (std::size_t i = 0; i < 4; ++i) {
      whole.low[i] = std::min(whole.low[i], mean.low[i]);
      whole.high[i] = std::max(whole.high[i], mean.high[i]);
    }
  }
  return whole;
}

class SamplePairs : public ::testing::TestWithParam<const char *> {
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
    const float most[] = {1, 2, 2.5f, 16};
    texture.view.maxAnisotropy = most[random() % std::size(most)];
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
          ASSERT_NEAR(raw[i], double(pixels.result[i][std::size_t(pixel)]), 1e-6) << "packed";
        }
      }
    }
  }
  /// Checks that no coordinate reads outside; the guard pages detect it.
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

TEST_P(SamplePairs, AgreeWithTheReference) {
  std::mt19937 random(20041);
  for (const Case &test : pairwiseCases(random)) {
    if (test.key.mip != abi::MipFilter::None || test.key.magnify != test.key.minify ||
        test.key.shadow || test.key.dimension == abi::Dimension::Cube)
      check(test, random);
    if (HasFatalFailure())
      return;
  }
}

/// Tests TXL in rows and quads: derivatives have no effect, and there is only one sample.
TEST_P(SamplePairs, TakeAGivenLevel) {
  std::mt19937 random(77);
  int cases = 0;
  for (Case test : pairwiseCases(random)) {
    if (test.key.mip == abi::MipFilter::None || ++cases % 3 != 0)
      continue;
    test.key.anisotropic = 0;
    test.options.lod = true;
    check(test, random);
    if (HasFatalFailure())
      return;
  }
  EXPECT_GT(cases, 20);
}

INSTANTIATE_TEST_SUITE_P(Cpus, SamplePairs, ::testing::Values("", "avx512", "avx2", "sse4.1"));

} // namespace
} // namespace arbiter::fp::llvm_back::testing
