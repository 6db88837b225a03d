#pragma once
#include <algorithm>
#include <cstdint>

#include "swrast/setup/viewport.h"

/// Convex regions of pixels, as bounds and edges.
namespace arbiter::swrast {

/// An edge function. Pixel (x, y) is inside if a * x + b * y + c >= 0; c includes the fill rule.
struct Edge {
  std::int32_t a = 0, b = 0;
  std::int64_t c = 0;
};

/// Evaluates an edge over a rectangle of pixels, which must not be empty.
struct EdgeOver {
  std::int64_t corner; ///< value at the lower left pixel
  bool some, all;      ///< true if some, or all, pixels are inside
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
  std::int32_t left = 0, bottom = 0, right = 0, top = 0; ///< pixels, half-open, clipped
};

/// A convex region of pixels, with the planes it is shaded with.
struct Shape : Bounds {
  std::int32_t edgeCount = 0; ///< 0: the whole rectangle
  bool stippled = false;      ///< true if the polygon stipple applies
  Edge edges[4];
  abi::Primitive primitive;
};

/// Returns twice the area in snapped units; positive if counterclockwise.
[[nodiscard]] inline std::int64_t areaOf(const WindowVertex corner[3]) {
  const std::int64_t ax = corner[1].fixedX - corner[0].fixedX;
  const std::int64_t ay = corner[1].fixedY - corner[0].fixedY;
  const std::int64_t bx = corner[2].fixedX - corner[0].fixedX;
  const std::int64_t by = corner[2].fixedY - corner[0].fixedY;
  return ax * by - bx * ay;
}
/// Returns the edge from `from` to `to` of a counterclockwise polygon.
[[nodiscard]] Edge edgeBetween(const WindowVertex &from, const WindowVertex &to);
/// Returns the first pixel whose centre is at or beyond a snapped coordinate.
[[nodiscard]] constexpr std::int32_t pixelFrom(std::int32_t fixed) {
  return (fixed + kSubpixels - 1) >> kSubpixelBits;
}

/// Computes bounds from snapped corners. Returns false if no pixel of the clip rectangle can be
/// inside.
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
  // Pixels on a right or an upper edge are outside, but not those on a corner where a left edge
  // ends.
  bounds.right = std::min(clip.x + clip.width, (maxX >> kSubpixelBits) + 1);
  bounds.top = std::min(clip.y + clip.height, (maxY >> kSubpixelBits) + 1);
  return bounds.left < bounds.right && bounds.bottom < bounds.top;
}
/// Computes bounds and edges. Returns false if no pixel of the clip rectangle can be inside.
/// Requires area != 0.
[[nodiscard]] bool shapeOf(const Rect &clip, const WindowVertex corner[3], std::int64_t area,
                           Shape &shape);

} // namespace arbiter::swrast
