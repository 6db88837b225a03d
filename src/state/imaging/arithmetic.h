#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "state/imaging/pixels.h"

namespace arbiter::state::imaging {

/// Clamps to the range 0 to 1; NaN becomes 0.
[[nodiscard]] inline float clamped(float value) {
  return value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f;
}
[[nodiscard]] inline Rgba clamped(const Rgba &color) {
  return {clamped(color[0]), clamped(color[1]), clamped(color[2]), clamped(color[3])};
}

/// Returns the table index that a component selects: clamped, scaled to the greatest index,
/// rounded.
[[nodiscard]] std::size_t indexOf(float value, std::size_t entries);

/// Returns a GL enum that was passed as a float; 0 if it is none.
[[nodiscard]] inline unsigned nameOf(float value) {
  return value >= 0.0f && value < 65536.0f ? unsigned(value) : 0u;
}

/// A scale and a bias per component.
struct ScaleBias {
  Rgba scale = {1, 1, 1, 1};
  Rgba bias = {0, 0, 0, 0};

  [[nodiscard]] Rgba apply(const Rgba &color) const;
  void apply(Pixels &pixels) const;
  bool operator==(const ScaleBias &) const = default;
};

/// A matrix in column-major order.
using Matrix = std::array<float, 16>;
inline constexpr Matrix kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
void transform(Pixels &pixels, const Matrix &matrix);

/// The pixel transfer before all of ARB_imaging: scale and bias, then a map per component.
struct FirstArithmetic {
  ScaleBias scaleBias;
  bool maps = false; ///< MAP_COLOR
  std::array<std::vector<float>, 4> map;

  void apply(Pixels &pixels) const;
};

} // namespace arbiter::state::imaging
