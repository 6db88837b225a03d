#include "swrast/pixels.h"

#include <array>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "swrast/testing/canvas.h"

namespace arbiter::swrast {
namespace {

using testing::Canvas;

struct Case {
  explicit Case(std::uint32_t seed) : numbers(seed) {
    const auto below = [&](int count) { return int(numbers() % unsigned(count)); };
    image.width = 1 + below(12);
    image.height = 1 + below(9);
    // few values, so that neighbours often have the same colour
    for (int i = 0; i < image.width * image.height; ++i)
      colors.push_back({float(below(3)), 0, 0, float(below(2))});
    image.colors = reinterpret_cast<const float(*)[4]>(colors.data());
    image.x = below(80) - 20;
    image.y = below(60) - 15;
    constexpr float kZooms[] = {1, 1, 2, 3.25f, 0.5f, -1, -1.75f, 0};
    image.zoomX = kZooms[below(8)];
    image.zoomY = kZooms[below(8)];
  }
  /// Returns the colour at a pixel's centre, or null outside of the image. Follows the text of
  /// 3.6.4: the lower and the left edge count as inside.
  [[nodiscard]] const float *at(int x, int y) const {
    for (int n = 0; n < image.width; ++n)
      for (int m = 0; m < image.height; ++m)
        if (holds(image.x, image.zoomX, n, x) && holds(image.y, image.zoomY, m, y))
          return colors[std::size_t(m * image.width + n)].data();
    return nullptr;
  }
  static bool holds(int corner, float zoom, int number, int pixel) {
    const float one = float(corner) + zoom * float(number), other = one + zoom;
    const float centre = float(pixel) + 0.5f;
    return std::min(one, other) <= centre && centre < std::max(one, other);
  }
  std::mt19937 numbers;
  std::vector<std::array<float, 4>> colors;
  PixelImage image;
};

void countPacked(const abi::FragmentData *data, const abi::PrimitiveColumns *columns,
                 const abi::Pixel *pixels, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const abi::Primitive primitive = columns->at(pixels[i].column);
    if (pixels[i].isHelper == 0)
      Canvas::shadePixel(data, &primitive, columns->baseX + pixels[i].x,
                         columns->baseY + pixels[i].y);
  }
}

/// \param lanes 0 draws rows; a negative value selects packed shading with that many lanes
void expectColors(std::uint32_t seed, int lanes, int colorInput) {
  const Case drawn(seed);
  Canvas canvas(61, 47);
  if (lanes > 0)
    canvas.useQuads(lanes);
  if (lanes < 0) {
    canvas.shading.packed = countPacked;
    canvas.shading.lanes = -lanes;
  }
  canvas.state.clip = {3, 2, 50, 41};
  canvas.shading.inputCount = 1;
  BitFragments fragments;
  fragments.inputs[0][0] = 7;
  (void)rasterizePixels(canvas.state, canvas.shading, drawn.image, fragments, colorInput);
  for (int y = 0; y < canvas.height; ++y)
    for (int x = 0; x < canvas.width; ++x) {
      const bool inside = x >= 3 && x < 53 && y >= 2 && y < 43;
      const float *const color = inside ? drawn.at(x, y) : nullptr;
      ASSERT_EQ(canvas.at(x, y), color ? 1u : 0u) << "pixel " << x << ", " << y;
      if (color) {
        ASSERT_EQ(canvas.valueAt(x, y), colorInput == 0 ? color[0] : 7.0f);
      }
    }
}

TEST(Pixels, EachIsDrawnOnceWithItsColor) {
  for (std::uint32_t seed = 0; seed < 25; ++seed)
    for (const int lanes : {0, 4, 8, 16, -8, -16})
      for (const int colorInput : {0, -1}) {
        expectColors(seed, lanes, colorInput);
        ASSERT_FALSE(HasFailure()) << "seed " << seed << ", lanes " << lanes;
      }
}

TEST(Pixels, NoneAreDrawnOfAnEmptyImage) {
  Canvas canvas(8, 8);
  EXPECT_EQ(rasterizePixels(canvas.state, canvas.shading, {}, {}, 0).pixels, 0u);
}

} // namespace
} // namespace arbiter::swrast
