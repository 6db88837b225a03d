#pragma once
#include <cstdint>

#include "fp_compiler/abi.h"

/// Pixels as four floats and back, for what need not be fast.
namespace arbiter::swrast {

[[nodiscard]] float halfToFloat(std::uint16_t half);
/// Towards zero, as the software host makes them; what is too large becomes the largest number.
[[nodiscard]] std::uint16_t floatToHalf(float value);

/// `count` pixels of a colour format to RGBA; `pixels` need not be aligned.
void unpackPixels(const abi::Format &format, const std::uint8_t *pixels, int count,
                  float (*rgba)[4]);
/// RGBA to `count` pixels. Fixed-point components are clamped and rounded; a stored component that
/// stands for none of RGBA becomes 1. Components outside `writeMask` are kept.
void packPixels(const abi::Format &format, const float (*rgba)[4], int count, std::uint8_t *pixels,
                unsigned writeMask = 0xF);

/// Which of RGBA a stored component takes: 0 to 3, or 4 for the constant 1.
[[nodiscard]] int sourceOf(const abi::Swizzle &swizzle, int stored);

} // namespace arbiter::swrast
