#pragma once
#include <cstdint>

#include "swrast/draw_input.h"

/// Pixels that are fragments where a bit is set: Bitmap (OpenGL 2.1, 3.7), without GL.
namespace arbiter::swrast {

/// A rectangle of bits in memory, one a pixel, the lowest row first.
struct BitImage {
  const std::uint8_t *rows = nullptr;
  std::int64_t stride = 0;  ///< bytes from a row to the one above it
  std::int32_t skip = 0;    ///< bits of each row before its first pixel
  bool lowestFirst = false; ///< the first pixel of a byte is its lowest bit
  std::int32_t width = 0, height = 0;

  [[nodiscard]] bool at(std::int32_t x, std::int32_t y) const {
    const std::int64_t bit = std::int64_t(skip) + x;
    const unsigned byte = rows[y * stride + (bit >> 3)];
    const auto place = unsigned(bit & 7);
    return (byte >> (lowestFirst ? place : 7 - place) & 1u) != 0;
  }
};

/// What all of a bitmap's fragments have: it is that of one vertex.
struct BitFragments {
  float z = 0;        ///< window depth, in [0,1]
  float inverseW = 1; ///< 1 / clip w
  float inputs[abi::kMaxInputs][4] = {};
};

/// Returns the primitive that all fragments of an image are of.
[[nodiscard]] abi::Primitive primitiveOf(const Shading &shading, const BitFragments &fragments);

/// Draws the fragments, those within the clip rectangle, with pixel (0, 0) of the image at window
/// pixel (x, y). Neither culling, stipples nor polygon offset apply. No input is Perspective.
/// Returns when all pixels are written.
DrawStatistics rasterizeBits(const RasterState &state, const Shading &shading, const BitImage &bits,
                             std::int32_t x, std::int32_t y, const BitFragments &fragments);

} // namespace arbiter::swrast
