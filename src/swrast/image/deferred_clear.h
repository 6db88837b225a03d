#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "swrast/rect.h"

/// Clears of whole images that are written where, and when, their pixels are first needed.
namespace arbiter::swrast {

/// What a clear does to 16 bytes of pixels, which no pixel's size straddles: bits of `mask` become
/// those of `value`.
struct ClearPattern {
  alignas(16) std::uint8_t value[16] = {};
  alignas(16) std::uint8_t mask[16] = {};
  /// All bits of a pixel are replaced.
  [[nodiscard]] bool isWhole() const;
  /// Nothing is left of a clear by `other` before this one.
  [[nodiscard]] bool replaces(const ClearPattern &other) const;
};

/// Where the pixels of an image of one slice lie.
struct ClearedPixels {
  std::uint8_t *base = nullptr; ///< of pixel (0, 0)
  std::int64_t rowStride = 0;   ///< bytes
  int width = 0, height = 0;
  int pixelBytes = 0; ///< 1, 2, 4, 8 or 16
  bool operator==(const ClearedPixels &) const = default;
};

/// Writes the pattern to a rectangle.
void writePattern(const ClearedPixels &pixels, const ClearPattern &pattern, const Rect &rect);

/// The clear of one image that is still to be written, in part: a tile of 64x64 pixels at a time,
/// by the thread that draws to the tile first, so that it lies in that processor's cache when it is
/// drawn to; what is neither drawn to nor read is never written.
class DeferredClear {
public:
  static constexpr int kTileShift = 6, kTile = 1 << kTileShift;

  /// From a store of a few that are free; null if there is no memory.
  [[nodiscard]] static DeferredClear *take();
  static void giveBack(DeferredClear *clear);

  /// Clears the image. What of a clear before it is still to be written is forgotten, or written
  /// where the new one leaves some of it. False if there is no memory; then nothing is pending.
  [[nodiscard]] bool begin(const ClearedPixels &pixels, const ClearPattern &pattern);
  [[nodiscard]] bool isPending() const { return m_left.load(std::memory_order_relaxed) != 0; }
  /// Before pixels of the rectangle are read or written. Threads may reach different tiles at a
  /// time, none the same.
  void reach(const Rect &rect);
  /// Before pixels anywhere are read or written; no other thread is at it.
  void complete();
  /// All pixels are about to be replaced.
  void forget() { m_left.store(0, std::memory_order_relaxed); }

private:
  void write(std::size_t tile);

  ClearedPixels m_pixels;
  ClearPattern m_pattern;
  int m_tilesX = 0, m_tilesY = 0;
  std::vector<std::uint8_t> m_pending; ///< a byte a tile, each written by one thread at a time
  std::atomic<std::uint32_t> m_left{0};
};

} // namespace arbiter::swrast
