#include "fp_compiler/numerics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace arbiter::fp {

namespace {

constexpr int kDropped = 23 - fp24::kMantissaBits;
constexpr std::uint32_t kSign = 0x80000000u;
constexpr std::uint32_t kInfinity = 0x7F800000u;

/// Moves a finite value into the range of the format: a large one becomes +-beyond, a small one
/// zero. Infinities and NaNs stay.
float inRange(float value, float beyond) {
  const float size = std::fabs(value);
  if (!(size <= fp24::kGreatest))
    return std::isfinite(value) ? std::copysign(beyond, value) : value;
  return size < fp24::kLeastNormal ? std::copysign(0.0f, value) : value;
}

} // namespace

std::optional<Numerics> numericsNamed(std::string_view name) {
  const auto found = std::find(kNumericsNames.begin(), kNumericsNames.end(), name);
  if (found == kNumericsNames.end())
    return std::nullopt;
  return Numerics(found - kNumericsNames.begin());
}

namespace fp24 {

float rounded(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  if ((bits & ~kSign) >= kInfinity)
    return value;
  constexpr std::uint32_t kHalf = 1u << (kDropped - 1);
  const std::uint32_t even = (bits >> kDropped) & 1u;
  const std::uint32_t nearest = (bits + kHalf - 1 + even) & ~((1u << kDropped) - 1);
  return inRange(std::bit_cast<float>(nearest), std::numeric_limits<float>::infinity());
}

float truncated(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  if ((bits & ~kSign) >= kInfinity)
    return value;
  return inRange(std::bit_cast<float>(bits & ~((1u << kDropped) - 1)), kGreatest);
}

float color(float value) {
  const float unit = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
  return rounded(std::nearbyint(unit * 4095.0f) * (1.0f / 4095.0f));
}

} // namespace fp24

} // namespace arbiter::fp
