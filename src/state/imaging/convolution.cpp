#include "state/imaging/convolution.h"

#include <algorithm>

#include "state/imaging/formats.h"

namespace arbiter::state::imaging {

namespace {

/// Returns the source pixel at a place, which may be outside the image.
const Rgba &sourceAt(const Pixels &source, const Border &border, int x, int y) {
  if (border.mode == GL_CONSTANT_BORDER &&
      (x < 0 || y < 0 || x >= source.width || y >= source.height))
    return border.color;
  return source.at(std::clamp(x, 0, source.width - 1), std::clamp(y, 0, source.height - 1));
}

Rgba weigh(const Pixels &source, const Filter &filter, const Border &border, int x, int y) {
  Rgba sum = {0, 0, 0, 0};
  for (int m = 0; m < filter.image.height; ++m)
    for (int n = 0; n < filter.image.width; ++n) {
      const Rgba &color = sourceAt(source, border, x + n, y + m);
      const Rgba &weight = filter.image.at(n, m);
      for (std::size_t c = 0; c < 4; ++c)
        sum[c] += color[c] * weight[c];
    }
  return sum;
}

} // namespace

Filter product(const Filter &row, const Filter &column) {
  Filter result{row.format, {row.image.width, column.image.width, 1, {}}};
  result.image.texels.reserve(result.image.count());
  for (const Rgba &y : column.image.texels)
    for (const Rgba &x : row.image.texels)
      result.image.texels.push_back({x[0] * y[0], x[1] * y[1], x[2] * y[2], x[3] * y[3]});
  return result;
}

int convolvedSize(int size, int filter, const Border &border) {
  return border.mode == GL_REDUCE ? std::max(size - filter + 1, 0) : size;
}

Pixels convolve(const Pixels &source, const Filter &filter, const Border &border) {
  const Base base = baseOf(filter.format);
  const int middleX = filter.image.width / 2, middleY = filter.image.height / 2;
  const bool reduces = border.mode == GL_REDUCE;
  const int left = reduces ? 0 : -middleX, bottom = reduces ? 0 : -middleY;
  Pixels result{convolvedSize(source.width, filter.image.width, border),
                convolvedSize(source.height, filter.image.height, border),
                1,
                {}};
  result.texels.reserve(result.count());
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      Rgba color = weigh(source, filter, border, x + left, y + bottom);
      const Rgba &under = source.at(x + left + middleX, y + bottom + middleY);
      for (std::size_t c = 0; c < 4; ++c)
        if (!acts(base, int(c)))
          color[c] = under[c];
      result.texels.push_back(color);
    }
  return result;
}

} // namespace arbiter::state::imaging
