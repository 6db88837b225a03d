#include "swrast/bits.h"

#include <algorithm>

#include "swrast/cover/flush_mode.h"

namespace arbiter::swrast {
namespace {

/// The part of a bitmap inside the clip rectangle.
struct Clipped {
  const BitImage &bits;
  std::int32_t x, y; ///< window coordinates of the bitmap's pixel (0, 0)
  Rect rect;         ///< window pixels to draw

  [[nodiscard]] bool at(std::int32_t windowX, std::int32_t windowY) const {
    return bits.at(windowX - x, windowY - y);
  }
};

/// Gathers items so that one call of the shading function takes many.
template <typename Item> class Batch {
public:
  Batch(abi::ShadeFunction shade, const abi::FragmentData *data, const abi::Primitive &primitive)
      : m_shade(shade), m_data(data), m_primitive(primitive) {}
  ~Batch() { flush(); }
  Batch(const Batch &) = delete;
  Batch &operator=(const Batch &) = delete;
  void add(const Item &item) {
    m_items[m_count++] = item;
    if (m_count == kMax)
      flush();
  }

private:
  static constexpr std::uint32_t kMax = 256;
  void flush() {
    if (m_count != 0)
      m_shade(m_data, &m_primitive, m_items, m_count);
    m_count = 0;
  }
  abi::ShadeFunction m_shade;
  const abi::FragmentData *m_data;
  const abi::Primitive &m_primitive;
  std::uint32_t m_count = 0;
  Item m_items[kMax];
};

std::uint64_t addRuns(const Clipped &part, Batch<abi::Span> &spans) {
  std::uint64_t pixels = 0;
  const std::int32_t right = part.rect.x + part.rect.width;
  for (std::int32_t y = part.rect.y; y < part.rect.y + part.rect.height; ++y)
    for (std::int32_t x = part.rect.x; x < right; ++x) {
      if (!part.at(x, y))
        continue;
      const std::int32_t from = x;
      while (++x < right && part.at(x, y))
        ;
      spans.add({std::int16_t(from), std::int16_t(y), std::uint16_t(x - from), 0});
      pixels += std::uint64_t(x - from);
    }
  return pixels;
}

std::uint64_t addBlocks(const Clipped &part, int width, int height, Batch<abi::Block> &blocks) {
  std::uint64_t pixels = 0;
  const Rect &rect = part.rect;
  const std::int32_t right = rect.x + rect.width, top = rect.y + rect.height;
  for (std::int32_t y = rect.y & -height; y < top; y += height)
    for (std::int32_t x = rect.x & -width; x < right; x += width) {
      unsigned mask = 0;
      for (int bit = 0; bit < width * height; ++bit) {
        const std::int32_t px = x + bit % width, py = y + bit / width;
        if (px >= rect.x && px < right && py >= rect.y && py < top && part.at(px, py)) {
          mask |= 1u << bit;
          ++pixels;
        }
      }
      if (mask != 0)
        blocks.add({std::int16_t(x), std::int16_t(y), std::uint16_t(mask), 0});
    }
  return pixels;
}

} // namespace

abi::Primitive primitiveOf(const Shading &shading, const BitFragments &fragments) {
  abi::Primitive primitive;
  primitive.backFacing = 0; // points, lines, bitmaps and pixel rectangles are always front-facing
  primitive.z = {fragments.z, 0, 0};
  primitive.inverseW = {fragments.inverseW, 0, 0};
  for (std::size_t i = 0; i < shading.inputCount; ++i)
    for (std::size_t c = 0; c < 4; ++c)
      primitive.inputs[i][c] = {fragments.inputs[i][c], 0, 0};
  return primitive;
}

DrawStatistics rasterizeBits(const RasterState &state, const Shading &shading, const BitImage &bits,
                             std::int32_t x, std::int32_t y, const BitFragments &fragments) {
  const Clipped part = {bits, x, y, intersect(state.clip, {x, y, bits.width, bits.height})};
  if (part.rect.empty() || (!shading.row && !shading.quad))
    return {};
  const abi::Primitive primitive = primitiveOf(shading, fragments);
  state.clears.reach(part.rect);
  const FlushMode mode;
  std::uint64_t pixels = 0;
  if (shading.row) {
    Batch<abi::Span> spans(shading.row, shading.data, primitive);
    pixels = addRuns(part, spans);
  } else {
    Batch<abi::Block> blocks(shading.quad, shading.data, primitive);
    pixels = addBlocks(part, shading.blockWidth, shading.blockHeight, blocks);
  }
  return {1, pixels};
}

} // namespace arbiter::swrast
