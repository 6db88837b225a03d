#pragma once
#include <cstdint>

#include "fp_compiler/abi.h"

/// Converts pixels to four floats and back, where speed does not matter.
namespace arbiter::swrast {

/// Rounds towards zero, as the software host does. Values that are too large become the largest
/// half.
[[nodiscard]] std::uint16_t floatToHalf(float value);

/// Converts `count` pixels of a colour format to RGBA. `pixels` need not be aligned.
void unpackPixels(const abi::Format &format, const std::uint8_t *pixels, int count,
                  float (*rgba)[4]);
/// Converts RGBA to `count` pixels. Fixed-point components are clamped and rounded. A stored
/// component that has no source in RGBA becomes 1. Components outside `writeMask` are kept.
void packPixels(const abi::Format &format, const float (*rgba)[4], int count, std::uint8_t *pixels,
                unsigned writeMask = 0xF);

/// Returns the index in RGBA that a stored component takes: 0 to 3, or 4 for the constant 1.
[[nodiscard]] int sourceOf(const abi::Swizzle &swizzle, int stored);

} // namespace arbiter::swrast
