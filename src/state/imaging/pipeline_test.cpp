// Compares each operation of ARB_imaging with its formula.
#include "state/imaging/pipeline.h"

#include <gtest/gtest.h>

#include "state/imaging/formats.h"

namespace arbiter::state::imaging {
namespace {

constexpr GLenum kFormats[] = {GL_ALPHA,     GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                               GL_INTENSITY, GL_RGB,       GL_RGBA};

Pixels gradient(int width, int height) {
  Pixels pixels{width, height, 1, {}};
  for (int i = 0; i < width * height; ++i)
    pixels.texels.push_back({float(i), float(2 * i), float(3 * i), float(4 * i)});
  return pixels;
}

TEST(Imaging, WhatAFormatHasAndActsOn) {
  const Rgba color = {1, 2, 3, 4};
  const Rgba selected[] = {{0, 0, 0, 4}, {1, 1, 1, 0}, {1, 1, 1, 4},
                           {1, 1, 1, 1}, {1, 2, 3, 0}, {1, 2, 3, 4}};
  const Rgba given[] = {{0, 0, 0, 4}, {1, 0, 0, 0}, {1, 0, 0, 4},
                        {1, 0, 0, 0}, {1, 2, 3, 0}, {1, 2, 3, 4}};
  for (std::size_t i = 0; i < 6; ++i) {
    const Base base = baseOf(kFormats[i]);
    EXPECT_EQ(select(base, color), selected[i]) << i;
    EXPECT_EQ(returned(base, selected[i]), given[i]) << i;
    for (int c = 0; c < 4; ++c)
      EXPECT_EQ(acts(base, c), selected[i][std::size_t(c)] != 0) << i << " " << c;
  }
  EXPECT_EQ(findFormat(GL_DEPTH_COMPONENT), nullptr);
  EXPECT_EQ(findFormat(3), nullptr);
}

TEST(Imaging, ATableHasItsFormatsPrecision) {
  const Rgba color = rounded(*findFormat(GL_RGB5_A1), {0.5f, 0.49f, 1, 0.4f});
  EXPECT_FLOAT_EQ(color[0], 16.0f / 31);
  EXPECT_FLOAT_EQ(color[1], 15.0f / 31);
  EXPECT_FLOAT_EQ(color[2], 1);
  EXPECT_FLOAT_EQ(color[3], 0);
}

TEST(Imaging, AnIndexIsTheNearest) {
  EXPECT_EQ(indexOf(-5, 4), 0u);
  EXPECT_EQ(indexOf(0.16f, 4), 0u);
  EXPECT_EQ(indexOf(0.17f, 4), 1u);
  EXPECT_EQ(indexOf(2, 4), 3u);
  EXPECT_EQ(indexOf(0.9f, 1), 0u);
}

TEST(Imaging, ATableReplacesWhatItsFormatActsOn) {
  for (const GLenum format : kFormats) {
    ColorTable table{format, std::vector<Rgba>(2)};
    table.set(1, {{0.2f, 0.4f, 0.6f, 0.8f}});
    Pixels pixels{1, 1, 1, {{1, 1, 0, 1}}};
    const Rgba before = pixels.texels[0];
    table.apply(pixels);
    for (std::size_t c = 0; c < 4; ++c) {
      const float entry = before[c] == 0.0f ? 0.0f : table.entries[1][c];
      EXPECT_EQ(pixels.texels[0][c], acts(baseOf(format), int(c)) ? entry : before[c])
          << format << " " << c;
    }
  }
  Pixels pixels = gradient(2, 1);
  ColorTable{}.apply(pixels);
  EXPECT_EQ(pixels.texels, gradient(2, 1).texels) << "without entries";
}

TEST(Imaging, ScaleBiasAndMatrix) {
  Pixels pixels{1, 1, 1, {{1, 2, 3, 4}}};
  ScaleBias{{2, 3, 4, 5}, {1, 0, -1, 0.5f}}.apply(pixels);
  EXPECT_EQ(pixels.texels[0], (Rgba{3, 6, 11, 20.5f}));
  Matrix matrix{};
  for (std::size_t i = 0; i < 16; ++i)
    matrix[i] = float(i);
  pixels.texels[0] = {1, 10, 100, 1000};
  transform(pixels, matrix);
  EXPECT_EQ(pixels.texels[0], (Rgba{12840, 13951, 15062, 16173})) << "column after column";
}

TEST(Imaging, ReducingLeavesTheMiddleOut) {
  Filter filter{GL_RGBA, {2, 2, 1, std::vector<Rgba>(4, {1, 1, 1, 1})}};
  const Pixels result = convolve(gradient(3, 2), filter, {});
  ASSERT_EQ(result.width, 2);
  ASSERT_EQ(result.height, 1);
  EXPECT_EQ(result.texels[0][0], 0 + 1 + 3 + 4);
  EXPECT_EQ(result.texels[1][3], 4 * (1 + 2 + 4 + 5));
  EXPECT_EQ(convolve(gradient(1, 1), filter, {}).count(), 0u) << "the filter is the larger one";
}

TEST(Imaging, BordersKeepTheSize) {
  const Filter filter{GL_RGBA, {3, 1, 1, {{1, 1, 1, 1}, {10, 10, 10, 10}, {100, 100, 100, 100}}}};
  const Pixels constant = convolve(gradient(2, 1), filter, {GL_CONSTANT_BORDER, {7, 7, 7, 7}});
  ASSERT_EQ(constant.width, 2);
  EXPECT_EQ(constant.texels[0][0], 7 + 0 + 100);
  EXPECT_EQ(constant.texels[1][0], 0 + 10 + 700);
  const Pixels replicated = convolve(gradient(2, 1), filter, {GL_REPLICATE_BORDER});
  EXPECT_EQ(replicated.texels[0][1], 0 + 0 + 200);
  EXPECT_EQ(replicated.texels[1][1], 0 + 20 + 200);
}

TEST(Imaging, AnotherComponentIsThatUnderTheMiddle) {
  const Filter filter{GL_ALPHA, {3, 1, 1, std::vector<Rgba>(3, {0, 0, 0, 1})}};
  const Pixels result = convolve(gradient(4, 1), filter, {});
  ASSERT_EQ(result.width, 2);
  EXPECT_EQ(result.texels[0], (Rgba{1, 2, 3, 4 * (0 + 1 + 2)}));
}

TEST(Imaging, ASeparableFilterIsTheProduct) {
  const Filter row{GL_RGBA, {2, 1, 1, {{1, 2, 3, 4}, {5, 6, 7, 8}}}};
  const Filter column{GL_RGBA, {3, 1, 1, {{1, 1, 1, 1}, {2, 2, 2, 2}, {0, 1, 0, 1}}}};
  const Filter both = product(row, column);
  ASSERT_EQ(both.image.width, 2);
  ASSERT_EQ(both.image.height, 3);
  EXPECT_EQ(both.image.at(1, 1), (Rgba{10, 12, 14, 16}));
  EXPECT_EQ(both.image.at(0, 2), (Rgba{0, 2, 0, 4}));
}

TEST(Imaging, TheConvolutionOfTwoDimensionsComesFirst) {
  Settings settings;
  Contents contents;
  settings.enabled = bitOf(Stage::Convolution2D) | bitOf(Stage::Separable2D);
  contents.row = contents.column = {GL_RGBA, {1, 1, 1, {{1, 1, 1, 1}}}};
  EXPECT_EQ(filterOf(settings, contents, ImageKind::Two), -1) << "no filter was given";
  contents.filters[1] = contents.row;
  EXPECT_EQ(filterOf(settings, contents, ImageKind::Two), 1);
  settings.enabled = bitOf(Stage::Separable2D);
  EXPECT_EQ(filterOf(settings, contents, ImageKind::Two), 2);
  EXPECT_EQ(filterOf(settings, contents, ImageKind::One), -1);
  EXPECT_EQ(filterOf(settings, contents, ImageKind::Three), -1);
}

TEST(Imaging, CountersAreOfTheFormatsComponents) {
  Histogram histogram{GL_LUMINANCE_ALPHA, false, std::vector<Counts>(2)};
  histogram.count({1, 1, 1, {{1, 1, 1, 0}}});
  EXPECT_EQ(histogram.bins[1], (Counts{1, 0, 0, 0}));
  EXPECT_EQ(histogram.bins[0], (Counts{0, 0, 0, 1}));
  Minmax minmax;
  minmax.count({2, 1, 1, {{-3, 0, 0, 1}, {4, 0, 0, 9}}});
  EXPECT_EQ(minmax.least[0], -3);
  EXPECT_EQ(minmax.most[0], 4);
  EXPECT_EQ(minmax.most[3], 9);
}

TEST(Imaging, ASinkTakesThePixels) {
  Settings settings;
  Contents contents;
  settings.enabled = bitOf(Stage::Histogram) | bitOf(Stage::Minmax);
  contents.histogram.sink = true;
  Pixels pixels = gradient(1, 1);
  EXPECT_FALSE(run(settings, contents, kIdentity, ImageKind::Two, pixels));
  EXPECT_EQ(contents.minmax.most[0], -Minmax::kMax) << "it is behind the histogram";
  contents.histogram.sink = false;
  EXPECT_TRUE(run(settings, contents, kIdentity, ImageKind::Two, pixels));
  EXPECT_EQ(contents.minmax.most[0], 0);
}

} // namespace
} // namespace arbiter::state::imaging
