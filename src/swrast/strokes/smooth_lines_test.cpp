// Checks which pixels smooth lines reach, and how much of each they cover.
#include <gtest/gtest.h>

#include <cmath>

#include "swrast/testing/canvas.h"

namespace arbiter::swrast {
namespace {

using testing::Canvas;
using testing::drawAll;
using testing::WindowVertices;

struct Line {
  double x0, y0, x1, y1;
  float width;
};

/// Writes the covered part of a pixel (abi::Coverage).
void shadeCovered(const abi::FragmentData *data, const abi::Primitive *primitive, const void *items,
                  std::uint32_t count) {
  const auto *const spans = static_cast<const abi::Span *>(items);
  for (std::uint32_t i = 0; i < count; ++i)
    for (int column = 0; column < spans[i].count; ++column) {
      const int x = spans[i].x + column, y = spans[i].y;
      const auto at = [&](int component) {
        const abi::Plane &plane = primitive->inputs[0][component];
        return abi::planeAt(plane, x, y - data->originY);
      };
      const auto part = [&](int from) {
        return std::clamp(at(from + 2) - std::fabs(at(from)), 0.0f, 1.0f);
      };
      const abi::Target &target = data->targets[1];
      *reinterpret_cast<float *>(target.base + std::ptrdiff_t(y) * target.rowStride +
                                 std::ptrdiff_t(x) * 4) += part(0) * part(1);
    }
}

DrawStatistics draw(Canvas &canvas, const Line &line) {
  canvas.state.coverage = abi::Coverage::Line;
  canvas.state.lineWidth = line.width;
  canvas.shading.inputCount = 1;
  canvas.shading.interpolation[0] = abi::Interpolation::Linear;
  canvas.shading.row = shadeCovered;
  WindowVertices vertices(canvas);
  vertices.add(line.x0, line.y0);
  vertices.add(line.x1, line.y1);
  return drawAll(canvas, Topology::Lines, vertices);
}

double coveredBy(const Canvas &canvas) {
  double sum = 0;
  for (int y = 0; y < canvas.height; ++y)
    for (int x = 0; x < canvas.width; ++x)
      sum += double(canvas.valueAt(x, y));
  return sum;
}

TEST(SmoothLines, CoverAsMuchAsTheyAreLargeWhateverTheirSlope) {
  for (int degrees = 0; degrees < 360; degrees += 15) {
    Canvas canvas(64, 64);
    const double angle = degrees * M_PI / 180;
    draw(canvas, {32.2, 31.7, 32.2 + 24 * std::cos(angle), 31.7 + 24 * std::sin(angle), 3});
    // At each side, coverage fades over one pixel centred on the side. Sampling the fade at whole
    // pixels adds an error of a sixteenth of a pixel along the sides.
    EXPECT_NEAR(coveredBy(canvas), 24 * 3, 3) << degrees;
  }
}

TEST(SmoothLines, FadeOverOnePixelAtEachSide) {
  Canvas canvas(32, 32);
  draw(canvas, {4.5, 10.25, 27.5, 10.25, 1});
  // The line lies 0.75 above the centre of row 9, 0.25 below that of row 10, and 1.25 below that of
  // row 11.
  EXPECT_NEAR(canvas.valueAt(16, 9), 0.25, 1e-4);
  EXPECT_NEAR(canvas.valueAt(16, 10), 0.75, 1e-4);
  EXPECT_EQ(canvas.valueAt(16, 11), 0);
  EXPECT_EQ(canvas.valueAt(3, 10), 0) << "half a pixel beyond the end and no further";
  EXPECT_NEAR(canvas.valueAt(4, 10), 0.375, 1e-4) << "half of the end's pixel";
}

TEST(SmoothLines, CoverLessOfAPixelThanItIsLong) {
  for (const double length : {0.1, 0.4, 0.9}) {
    Canvas canvas(16, 16);
    draw(canvas, {8.5 - length / 2, 8.5, 8.5 + length / 2, 8.5, 1});
    EXPECT_NEAR(canvas.valueAt(8, 8), length, 1e-3);
  }
}

TEST(SmoothLines, OfNoLengthReachHalfAPixelAroundAndCoverNothing) {
  for (const float width : {1.0f, 2.0f, 5.0f}) {
    Canvas canvas(16, 16);
    const DrawStatistics drawn = draw(canvas, {8.5, 8, 8.5, 8, width});
    EXPECT_EQ(drawn.pixels, unsigned(width) + 1) << "its width and a half on each side";
    EXPECT_EQ(coveredBy(canvas), 0);
  }
}

TEST(SmoothLines, ArePlacedAlikeInImagesThatAreUpsideDown) {
  Canvas upright(48, 48), turned(48, 48);
  turned.turn(true);
  const Line line = {5.3, 7.9, 40.2, 22.4, 2.5};
  draw(upright, line);
  draw(turned, line);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      ASSERT_NEAR(upright.valueAt(x, y), turned.valueAt(x, y), 2e-3) << x << ", " << y;
}

} // namespace
} // namespace arbiter::swrast
