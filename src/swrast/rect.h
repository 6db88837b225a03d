#pragma once
#include <algorithm>
#include <cstdint>

namespace arbiter::swrast {

/// A rectangle of a target's pixels; the origin is the lower left.
struct Rect {
  std::int32_t x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
  bool operator==(const Rect &) const = default;
};

/// Returns the pixels that are in both rectangles, or all zeros if there are none.
[[nodiscard]] inline Rect intersect(const Rect &a, const Rect &b) {
  const std::int64_t left = std::max(a.x, b.x), bottom = std::max(a.y, b.y);
  const std::int64_t right = std::min(std::int64_t(a.x) + a.width, std::int64_t(b.x) + b.width);
  const std::int64_t top = std::min(std::int64_t(a.y) + a.height, std::int64_t(b.y) + b.height);
  if (a.empty() || b.empty() || right <= left || top <= bottom)
    return {};
  return {std::int32_t(left), std::int32_t(bottom), std::int32_t(right - left),
          std::int32_t(top - bottom)};
}

} // namespace arbiter::swrast
