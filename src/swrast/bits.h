#pragma once
#include <cstdint>

#include "swrast/draw_input.h"

/// Rasterizes bitmaps: each set bit is a fragment, as for glBitmap (OpenGL 2.1, 3.7). Knows no GL.
namespace arbiter::swrast {

/// A rectangle of bits in memory, one bit a pixel, lowest row first.
struct BitImage {
  const std::uint8_t *rows = nullptr;
  std::int64_t stride = 0;  ///< bytes from one row to the row above it
  std::int32_t skip = 0;    ///< bits to skip at the start of each row
  bool lowestFirst = false; ///< true if the lowest bit of a byte is its first pixel
  std::int32_t width = 0, height = 0;

  [[nodiscard]] bool at(std::int32_t x, std::int32_t y) const {
    const std::int64_t bit = std::int64_t(skip) + x;
    const unsigned byte = rows[y * stride + (bit >> 3)];
    const auto place = unsigned(bit & 7);
    return (byte >> (lowestFirst ? place : 7 - place) & 1u) != 0;
  }
};

/// The attributes that all fragments of a bitmap share; they come from one vertex, the raster
/// position.
struct BitFragments {
  float z = 0;        ///< window depth, in [0,1]
  float inverseW = 1; ///< 1 / clip w
  float inputs[abi::kMaxInputs][4] = {};
};

/// Returns the primitive for the fragments of an image: all of its planes are constant.
[[nodiscard]] abi::Primitive primitiveOf(const Shading &shading, const BitFragments &fragments);

/// Draws the bitmap's fragments that lie within the clip rectangle. The bitmap's pixel (0, 0) is
/// drawn at window pixel (x, y). Culling, stipple and polygon offset do not apply. Requires that no
/// input is Perspective. Returns when all pixels are written.
DrawStatistics rasterizeBits(const RasterState &state, const Shading &shading, const BitImage &bits,
                             std::int32_t x, std::int32_t y, const BitFragments &fragments);

} // namespace arbiter::swrast
