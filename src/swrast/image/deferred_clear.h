#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "swrast/rect.h"

/// Clears of whole images that are written late: each part when its pixels are first needed.
namespace arbiter::swrast {

/// The effect of a clear on 16 bytes of pixels: bits of `mask` take the value in `value`. 16 is a
/// multiple of every pixel size.
struct ClearPattern {
  alignas(16) std::uint8_t value[16] = {};
  alignas(16) std::uint8_t mask[16] = {};
  /// True if all bits of a pixel are replaced.
  [[nodiscard]] bool isWhole() const;
  /// True if this clear overwrites everything that `other` would have written.
  [[nodiscard]] bool replaces(const ClearPattern &other) const;
};

/// The location of an image's pixels in memory; the image has one slice.
struct ClearedPixels {
  std::uint8_t *base = nullptr; ///< address of pixel (0, 0)
  std::int64_t rowStride = 0;   ///< bytes
  int width = 0, height = 0;
  int pixelBytes = 0; ///< 1, 2, 4, 8 or 16
  bool operator==(const ClearedPixels &) const = default;
};

/// Writes the pattern to all pixels of a rectangle.
void writePattern(const ClearedPixels &pixels, const ClearPattern &pattern, const Rect &rect);

/// A clear of one image that is partly still to be written. Each tile of 64x64 pixels is written by
/// the first thread that draws to it, so that it lies in that processor's cache when it is drawn
/// to. Tiles that are neither drawn to nor read are never written.
class DeferredClear {
public:
  static constexpr int kTileShift = 6, kTile = 1 << kTileShift;

  /// Returns an object from a small pool of free ones, or null if there is no memory.
  [[nodiscard]] static DeferredClear *take();
  static void giveBack(DeferredClear *clear);

  /// Begins a clear of the image. What an earlier clear has left pending is dropped, or written if
  /// the new clear keeps some of its bits. Returns false if there is no memory; nothing is pending
  /// then.
  [[nodiscard]] bool begin(const ClearedPixels &pixels, const ClearPattern &pattern);
  [[nodiscard]] bool isPending() const { return m_left.load(std::memory_order_relaxed) != 0; }
  /// Writes the pending tiles of a rectangle. Call it before its pixels are read or written.
  /// Threads may reach different tiles at the same time, but never the same tile.
  void reach(const Rect &rect);
  /// Writes all pending tiles. Requires that no other thread uses this clear.
  void complete();
  /// Drops all pending tiles. Call it when every pixel is about to be replaced.
  void forget() { m_left.store(0, std::memory_order_relaxed); }

private:
  void write(std::size_t tile);

  ClearedPixels m_pixels;
  ClearPattern m_pattern;
  int m_tilesX = 0, m_tilesY = 0;
  /// one byte a tile; a tile's byte is written by one thread at a time
  std::vector<std::uint8_t> m_pending;
  std::atomic<std::uint32_t> m_left{0};
};

} // namespace arbiter::swrast
