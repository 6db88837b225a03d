#include "swrast/pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#include "swrast/cover/flush_mode.h"
#include "util/numbers/same_bits.h"

namespace arbiter::swrast {
namespace {

/// Returns, for each of `length` pixels from `first` on, the index of the image column (or row)
/// that contains the pixel's centre. The image begins at `corner`. Requires that it covers all of
/// these pixels.
std::vector<std::int32_t> sourcesOf(std::int32_t first, std::int32_t length, std::int32_t corner,
                                    float zoom, std::int32_t count) {
  std::vector<std::int32_t> sources(static_cast<std::size_t>(length));
  for (std::int32_t i = 0; i < length; ++i) {
    const double place = (double(first - corner) + i + 0.5) / double(zoom);
    const double source = zoom > 0 ? std::floor(place) : std::ceil(place) - 1;
    sources[std::size_t(i)] = std::int32_t(std::clamp(source, 0.0, double(count - 1)));
  }
  return sources;
}

/// Returns the first pixel whose centre is at or beyond `edge`.
std::int32_t firstBehind(double edge) {
  constexpr double kFar = 1 << 20;
  return std::int32_t(std::clamp(std::ceil(edge - 0.5), -kFar, kFar));
}

/// Returns the rectangle of window pixels that the image covers.
Rect coveredBy(const PixelImage &image) {
  const double right = image.x + double(image.zoomX) * image.width;
  const double top = image.y + double(image.zoomY) * image.height;
  const std::int32_t x = firstBehind(std::min(double(image.x), right));
  const std::int32_t y = firstBehind(std::min(double(image.y), top));
  return {x, y, firstBehind(std::max(double(image.x), right)) - x,
          firstBehind(std::max(double(image.y), top)) - y};
}

/// Shades a run of pixels in one row. All of them have the primitive's colour.
void shadeRun(const Shading &shading, const abi::Primitive &primitive, std::int32_t x,
              std::int32_t y, std::int32_t count) {
  if (shading.row) {
    const abi::Span span = {std::int16_t(x), std::int16_t(y), std::uint16_t(count), 0};
    shading.row(shading.data, &primitive, &span, 1);
    return;
  }
  const std::int32_t width = shading.blockWidth, height = shading.blockHeight;
  for (std::int32_t from = x; from < x + count;) {
    const std::int32_t blockX = from & -width;
    const std::int32_t to = std::min(x + count, blockX + width);
    unsigned mask = 0;
    for (std::int32_t i = from; i < to; ++i)
      mask |= 1u << ((y & (height - 1)) * width + (i - blockX));
    const abi::Block block = {std::int16_t(blockX), std::int16_t(y & -height), std::uint16_t(mask),
                              0};
    shading.quad(shading.data, &primitive, &block, 1);
    from = to;
  }
}

/// Shades rows of pixels that each have their own colour, one vector of lanes at a time.
class PackedRows {
public:
  PackedRows(const Shading &shading, const abi::Primitive &primitive, int colorInput)
      : m_shading(shading) {
    for (int column = 0; column < abi::PrimitiveColumns::kColumns; ++column)
      m_columns.set(column, primitive);
    for (std::size_t c = 0; c < 4; ++c)
      m_rows[c] = abi::PrimitiveColumns::rowOf(
          offsetof(abi::Primitive, inputs) +
          (std::size_t(colorInput) * 4 + c) * sizeof(abi::Plane) + offsetof(abi::Plane, c));
  }
  /// Shades pixels (x, y) to (x + count - 1, y).
  /// \param columns the index into `row` of each pixel's colour
  void shade(std::int32_t x, std::int32_t y, std::int32_t count, const float (*row)[4],
             const std::int32_t *columns) {
    m_columns.baseY = y;
    for (std::int32_t done = 0; done < count; done += m_shading.lanes) {
      m_columns.baseX = x + done;
      abi::Pixel pixels[abi::PrimitiveColumns::kColumns];
      for (int i = 0; i < m_shading.lanes; ++i) {
        const bool isLast = done + i >= count;
        pixels[i] = {std::uint8_t(isLast ? 0 : i), 0, std::uint8_t(i),
                     isLast ? abi::Pixel::kHelper : std::uint8_t(0)};
        for (std::size_t c = 0; c < 4 && !isLast; ++c)
          std::memcpy(&m_columns.rows[m_rows[c]][i], &row[columns[done + i]][c], sizeof(float));
      }
      m_shading.packed(m_shading.data, &m_columns, pixels, std::uint32_t(m_shading.lanes));
    }
  }

private:
  const Shading &m_shading;
  abi::PrimitiveColumns m_columns;
  std::array<std::size_t, 4> m_rows = {};
};

} // namespace

DrawStatistics rasterizePixels(const RasterState &state, const Shading &shading,
                               const PixelImage &image, const BitFragments &fragments,
                               int colorInput) {
  if (image.width <= 0 || image.height <= 0 || (!shading.row && !shading.quad))
    return {};
  const Rect rect = intersect(state.clip, coveredBy(image));
  if (rect.empty())
    return {};
  abi::Primitive primitive = primitiveOf(shading, fragments);
  const auto columns = sourcesOf(rect.x, rect.width, image.x, image.zoomX, image.width);
  const auto rows = sourcesOf(rect.y, rect.height, image.y, image.zoomY, image.height);
  state.clears.reach(rect);
  const FlushMode mode;
  const std::uint64_t count = std::uint64_t(rect.width) * std::uint64_t(rect.height);
  if (shading.packed && !shading.packsQuads && colorInput >= 0 &&
      shading.depth.layout == abi::Layout::None) {
    PackedRows packed(shading, primitive, colorInput);
    for (std::int32_t y = 0; y < rect.height; ++y)
      packed.shade(rect.x, rect.y + y, rect.width,
                   image.colors + std::ptrdiff_t(rows[std::size_t(y)]) * image.width,
                   columns.data());
    return {1, count};
  }
  for (std::int32_t y = 0; y < rect.height; ++y) {
    const float(*const row)[4] = image.colors + std::ptrdiff_t(rows[std::size_t(y)]) * image.width;
    for (std::int32_t x = 0; x < rect.width;) {
      const float *const color = row[columns[std::size_t(x)]];
      const std::int32_t from = x;
      while (++x < rect.width &&
             (colorInput < 0 || sameBytes(row[columns[std::size_t(x)]], color, 16)))
        ;
      if (colorInput >= 0)
        for (std::size_t c = 0; c < 4; ++c)
          primitive.inputs[colorInput][c].c = color[c];
      shadeRun(shading, primitive, rect.x + from, rect.y + y, x - from);
    }
  }
  return {1, count};
}

} // namespace arbiter::swrast
