#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::testing {

inline constexpr float kInf = std::numeric_limits<float>::infinity();
inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Numbers at which the rules of ir/semantics.h and of fp24 change: zeros, denormals, the ends of
/// both formats, neighbours of one, infinities, NaN.
inline constexpr std::array<float, 26> kSpecials = {0.0f,
                                                    -0.0f,
                                                    1e-40f,
                                                    -1e-40f,
                                                    std::numeric_limits<float>::min(),
                                                    0x1p-63f,
                                                    0x1p-62f,
                                                    -0x1p-62f,
                                                    0x1.FFFFp-63f,
                                                    0x1p-17f,
                                                    0.5f,
                                                    1.0f,
                                                    -1.0f,
                                                    0x1.FFFEp-1f,
                                                    0x1.0001p0f,
                                                    0x1.000001p0f,
                                                    2.0f,
                                                    -3.0f,
                                                    0x1p17f,
                                                    0x1.FFFFp63f,
                                                    -0x1.FFFFp63f,
                                                    0x1p64f,
                                                    std::numeric_limits<float>::max(),
                                                    kInf,
                                                    -kInf,
                                                    kNan};

/// True if the numbers are equal bit by bit. All NaNs are equal.
[[nodiscard]] inline bool sameBits(float a, float b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

[[nodiscard]] inline bool sameBits(const ir::Vec4 &a, const ir::Vec4 &b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (!sameBits(a[i], b[i]))
      return false;
  return true;
}

} // namespace arbiter::fp::testing
