#pragma once
#include <bit>
#include <cstdint>

namespace arbiter {

/// Returns the value of a half float: 1 sign bit, 5 bits of exponent, 10 of fraction
/// (ARB_half_float_pixel 2.1.2). Exact: every half is a float. A NaN keeps its fraction and sign.
[[nodiscard]] constexpr float halfToFloat(std::uint16_t half) {
  const std::uint32_t sign = std::uint32_t(half & 0x8000u) << 16;
  const std::uint32_t magnitude = half & 0x7FFFu;
  if (magnitude >= 0x7C00u) // infinity or NaN
    return std::bit_cast<float>(sign | 0x7F800000u | (magnitude & 0x3FFu) << 13);
  if (magnitude >= 0x400u)
    return std::bit_cast<float>(sign | ((magnitude << 13) + 0x38000000u));
  const float denormal = float(magnitude) * 0x1p-24f;
  return sign != 0 ? -denormal : denormal;
}

} // namespace arbiter
