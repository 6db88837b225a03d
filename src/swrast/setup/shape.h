#pragma once
#include <algorithm>
#include <cstdint>

#include "swrast/setup/viewport.h"

/// Convex regions of pixels: bounds and edges.
namespace arbiter::swrast {

/// Inside where a * x + b * y + c >= 0, for pixels (x, y); the fill rule is in c.
struct Edge {
  std::int32_t a = 0, b = 0;
  std::int64_t c = 0;
};

/// An edge over a rectangle of pixels, which is not empty.
struct EdgeOver {
  std::int64_t corner; ///< its value at the lower left pixel
  bool some, all;      ///< whether there are pixels inside of it, and whether all are
  EdgeOver(const Edge &edge, const Rect &pixels) {
    const std::int64_t alongX = std::int64_t(edge.a) * (pixels.width - 1);
    const std::int64_t alongY = std::int64_t(edge.b) * (pixels.height - 1);
    const std::int64_t zero = 0;
    corner = std::int64_t(edge.a) * pixels.x + std::int64_t(edge.b) * pixels.y + edge.c;
    some = corner + std::max(alongX, zero) + std::max(alongY, zero) >= 0;
    all = corner + std::min(alongX, zero) + std::min(alongY, zero) >= 0;
  }
};

struct Bounds {
  std::int32_t left = 0, bottom = 0, right = 0, top = 0; ///< pixels, half open, clipped
};

/// A convex region of pixels and what it is shaded with.
struct Shape : Bounds {
  std::int32_t edgeCount = 0; ///< 0: the rectangle, whole
  bool stippled = false;      ///< by the polygon stipple
  Edge edges[4];
  abi::Primitive primitive;
};

/// Twice the area in snapped units; positive if counterclockwise.
[[nodiscard]] inline std::int64_t areaOf(const WindowVertex corner[3]) {
  const std::int64_t ax = corner[1].fixedX - corner[0].fixedX;
  const std::int64_t ay = corner[1].fixedY - corner[0].fixedY;
  const std::int64_t bx = corner[2].fixedX - corner[0].fixedX;
  const std::int64_t by = corner[2].fixedY - corner[0].fixedY;
  return ax * by - bx * ay;
}
/// The edge from `from` to `to` of a counterclockwise polygon.
[[nodiscard]] Edge edgeBetween(const WindowVertex &from, const WindowVertex &to);
/// The first pixel whose centre is at or behind a snapped coordinate.
[[nodiscard]] constexpr std::int32_t pixelFrom(std::int32_t fixed) {
  return (fixed + kSubpixels - 1) >> kSubpixelBits;
}

/// Bounds from snapped ones; false if no pixel of the clip rectangle can be inside.
[[nodiscard]] inline bool setBounds(const Rect &clip, const WindowVertex *corner, int count,
                                    Bounds &bounds) {
  std::int32_t minX = corner[0].fixedX, maxX = minX, minY = corner[0].fixedY, maxY = minY;
  for (int i = 1; i < count; ++i) {
    minX = std::min(minX, corner[i].fixedX);
    maxX = std::max(maxX, corner[i].fixedX);
    minY = std::min(minY, corner[i].fixedY);
    maxY = std::max(maxY, corner[i].fixedY);
  }
  const std::int32_t left = pixelFrom(minX), bottom = pixelFrom(minY);
  bounds.left = std::max(clip.x, left);
  bounds.bottom = std::max(clip.y, bottom);
  // A right or an upper edge is outside itself, but not a corner that a left edge ends in.
  bounds.right = std::min(clip.x + clip.width, (maxX >> kSubpixelBits) + 1);
  bounds.top = std::min(clip.y + clip.height, (maxY >> kSubpixelBits) + 1);
  return bounds.left < bounds.right && bounds.bottom < bounds.top;
}
/// Bounds and edges; false if no pixel of the clip rectangle can be inside. `area` is not 0.
[[nodiscard]] bool shapeOf(const Rect &clip, const WindowVertex corner[3], std::int64_t area,
                           Shape &shape);

} // namespace arbiter::swrast
