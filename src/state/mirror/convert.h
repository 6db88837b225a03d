#pragma once
#include <limits>
#include <type_traits>

/// Conversions of vertex attribute components to floats.
namespace arbiter::state {

/// Converts a fixed-point integer to [0,1] or [-1,1], by table 2.9 of OpenGL 2.1: a signed c of b
/// bits is (2c + 1) / (2^b - 1).
template <typename Integer> [[nodiscard]] constexpr float normalized(Integer value) {
  constexpr double kMax = std::numeric_limits<std::make_unsigned_t<Integer>>::max();
  if constexpr (std::is_unsigned_v<Integer>) {
    if constexpr (sizeof(Integer) < sizeof(int))
      return float(value) * float(1.0 / kMax);
    return float(double(value) / kMax);
  }
  return float((2.0 * value + 1.0) / kMax);
}

} // namespace arbiter::state
