#include "swrast/image/deferred_clear.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <mutex>
#include <new>

#include "swrast/threads.h"

namespace arbiter::swrast {
namespace {

constexpr int kPatternBytes = 16;
constexpr std::ptrdiff_t kLine = 64;
constexpr int kRowsAhead = 4;

using Word = std::uint64_t __attribute__((vector_size(kPatternBytes)));

Word wordOf(const std::uint8_t *bytes) {
  Word word;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

/// Spare clears. Never destroyed, because images may outlive the library's static objects.
struct Store {
  std::mutex mutex;
  std::array<DeferredClear *, 16> free{};
  std::size_t count = 0;
};
Store &store() {
  static Store *const instance = new Store;
  return *instance;
}

} // namespace

bool ClearPattern::isWhole() const {
  return std::all_of(std::begin(mask), std::end(mask),
                     [](std::uint8_t byte) { return byte == 0xFF; });
}

bool ClearPattern::replaces(const ClearPattern &other) const {
  return std::equal(
      std::begin(mask), std::end(mask), std::begin(other.mask),
      [](std::uint8_t mine, std::uint8_t theirs) { return (theirs & ~mine & 0xFF) == 0; });
}

void writePattern(const ClearedPixels &pixels, const ClearPattern &pattern, const Rect &rect) {
  const Rect all = intersect(rect, {0, 0, pixels.width, pixels.height});
  if (all.empty())
    return;
  const std::ptrdiff_t bytes = std::ptrdiff_t(all.width) * pixels.pixelBytes;
  const Word value = wordOf(pattern.value) & wordOf(pattern.mask), keep = ~wordOf(pattern.mask);
  const bool isWhole = pattern.isWhole();
  for (int y = all.y; y < all.y + all.height; ++y) {
    // The pattern repeats with every pixel, so it may begin at any pixel.
    std::uint8_t *const row =
        pixels.base + y * pixels.rowStride + std::ptrdiff_t(all.x) * pixels.pixelBytes;
    std::ptrdiff_t at = 0;
    // A masked clear reads pixels first, and they have left the nearer caches: prefetch them.
    if (!isWhole)
      for (std::ptrdiff_t line = 0; line < bytes; line += kLine)
        __builtin_prefetch(row + line + kRowsAhead * pixels.rowStride, 1, 3);
    if (isWhole)
      for (; at + kPatternBytes <= bytes; at += kPatternBytes)
        std::memcpy(row + at, &value, sizeof value);
    else
      for (; at + kPatternBytes <= bytes; at += kPatternBytes) {
        const Word cleared = (wordOf(row + at) & keep) | value;
        std::memcpy(row + at, &cleared, sizeof cleared);
      }
    for (std::ptrdiff_t i = 0; at < bytes; ++at, ++i)
      row[at] = std::uint8_t((row[at] & ~pattern.mask[i]) | (pattern.value[i] & pattern.mask[i]));
  }
}

DeferredClear *DeferredClear::take() {
  {
    Store &s = store();
    const std::lock_guard lock(s.mutex);
    if (s.count > 0)
      return s.free[--s.count];
  }
  return new (std::nothrow) DeferredClear;
}

void DeferredClear::giveBack(DeferredClear *clear) {
  if (!clear)
    return;
  clear->forget();
  {
    Store &s = store();
    const std::lock_guard lock(s.mutex);
    if (s.count < s.free.size()) {
      s.free[s.count++] = clear;
      return;
    }
  }
  delete clear;
}

bool DeferredClear::begin(const ClearedPixels &pixels, const ClearPattern &pattern) {
  if (isPending() && (!(pixels == m_pixels) || !pattern.replaces(m_pattern)))
    complete();
  forget();
  m_pixels = pixels;
  m_pattern = pattern;
  m_tilesX = (pixels.width + kTile - 1) >> kTileShift;
  m_tilesY = (pixels.height + kTile - 1) >> kTileShift;
  const std::size_t tiles = std::size_t(m_tilesX) * std::size_t(m_tilesY);
  try {
    m_pending.assign(tiles, 1);
  } catch (const std::bad_alloc &) {
    return false;
  }
  m_left.store(std::uint32_t(tiles), std::memory_order_relaxed);
  return true;
}

void DeferredClear::write(std::size_t tile) {
  const int x = int(tile) % m_tilesX, y = int(tile) / m_tilesX;
  writePattern(m_pixels, m_pattern, {x << kTileShift, y << kTileShift, kTile, kTile});
  m_pending[tile] = 0;
  m_left.fetch_sub(1, std::memory_order_relaxed);
}

void DeferredClear::reach(const Rect &rect) {
  if (!isPending())
    return;
  const Rect all = intersect(rect, {0, 0, m_pixels.width, m_pixels.height});
  if (all.empty())
    return;
  for (int y = all.y >> kTileShift; y <= (all.y + all.height - 1) >> kTileShift; ++y)
    for (int x = all.x >> kTileShift; x <= (all.x + all.width - 1) >> kTileShift; ++x) {
      const std::size_t tile = std::size_t(y) * std::size_t(m_tilesX) + std::size_t(x);
      if (m_pending[tile])
        write(tile);
    }
}

void DeferredClear::complete() {
  if (!isPending())
    return;
  auto row = [&](std::uint32_t y) { reach({0, int(y) << kTileShift, m_pixels.width, kTile}); };
  constexpr std::int64_t kTilePixels = std::int64_t(kTile) * kTile;
  const std::int64_t bytes =
      std::int64_t(m_left.load(std::memory_order_relaxed)) * kTilePixels * m_pixels.pixelBytes;
  if (bytes >= kParallelBytes)
    parallel(std::uint32_t(m_tilesY), row);
  else
    for (std::uint32_t y = 0; y < std::uint32_t(m_tilesY); ++y)
      row(y);
}

} // namespace arbiter::swrast
