#pragma once
#include <algorithm>
#include <cstdlib>

#include "swrast/setup/assembly.h"
#include "swrast/setup/clip.h"
#include "swrast/setup/draw.h"
#include "swrast/setup/shape.h"

/// Iterates over the triangles of a draw: assembles, clips and culls them.
namespace arbiter::swrast {

/// True if a triangle is back-facing. \p area is twice its area in snapped units, positive if
/// counterclockwise.
[[nodiscard]] inline bool isBackFacing(const RasterState &state, std::int64_t area) {
  return (area > 0) == state.frontIsClockwise;
}
/// True if polygons with that facing are culled.
[[nodiscard]] inline bool isCulled(const RasterState &state, bool backFacing) {
  return backFacing ? state.cullBack : state.cullFront;
}

/// Fetches the corners. Returns false if the triangle cannot be visible. \p any receives the union
/// of their outcodes.
[[nodiscard]] inline bool fetchTriangle(const Draw &draw, const TriangleCorners &corners,
                                        Triangle &triangle, std::uint32_t &any) {
  std::uint32_t all = ~0u;
  any = 0;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t index = draw.vertexAt(corners.corner[k]);
    if (index >= draw.vertices.count)
      return false;
    triangle.vertex[k] = index;
    triangle.corner[k] = draw.window[index];
    all &= triangle.corner[k].outcode;
    any |= triangle.corner[k].outcode;
  }
  triangle.provoking = draw.vertexAt(corners.provoking);
  return !(all & kOutsideMask) && !(any & kOutNan) && triangle.provoking < draw.vertices.count;
}

/// Rotates the corners into the order in which hosts clip: the provoking corner is the first or the
/// last.
inline void turnAsHostsWalk(const RasterState &state, Triangle &triangle) {
  const int wanted = state.provokingIsFirst ? 0 : 2;
  for (int i = 0; i < 2 && triangle.vertex[wanted] != triangle.provoking; ++i) {
    std::rotate(triangle.vertex, triangle.vertex + 1, triangle.vertex + 3);
    std::rotate(triangle.corner, triangle.corner + 1, triangle.corner + 3);
  }
}

/// Clips a triangle that leaves the view volume, and calls `take(triangle, shape)` for each
/// triangle of the fan. Hosts make the same fan, so each piece has the host's depths.
template <typename Take> void clipAndTake(const Draw &draw, Triangle &triangle, Take take) {
  if (hasTwins(draw.vertices, triangle.vertex))
    return;
  turnAsHostsWalk(draw.state, triangle);
  ClippedPolygon polygon;
  clipTriangle(draw.viewport, draw.vertices, triangle.vertex, triangle.corner, polygon);
  if (polygon.count < 3)
    return;
  const auto vertexAt = [&](int i) -> const ClipVertex & {
    return polygon.vertex[std::size_t(i == polygon.count ? 0 : i)];
  };
  std::int64_t area = 0;
  for (int i = 1; i + 1 < polygon.count; ++i) {
    const WindowVertex fan[3] = {vertexAt(0).window, vertexAt(i).window, vertexAt(i + 1).window};
    area += areaOf(fan);
  }
  if (area == 0)
    return;
  triangle.backFacing = isBackFacing(draw.state, area);
  if (isCulled(draw.state, triangle.backFacing))
    return;
  triangle.cuts = &polygon.cuts;
  const Rect clip = intersect(draw.state.clip, draw.viewport.pixels);
  for (int i = 1; i + 1 < polygon.count; ++i) {
    const int from[3] = {0, i, i + 1};
    for (int k = 0; k < 3; ++k) {
      triangle.corner[k] = vertexAt(from[k]).window;
      triangle.place[k] = vertexAt(from[k]).place;
    }
    const std::int64_t part = areaOf(triangle.corner);
    Shape shape;
    if (part == 0 || !setBounds(clip, triangle.corner, 3, shape))
      continue;
    for (int k = 0; k < 3; ++k) {
      const bool isDiagonal = (k == 0 && i > 1) || (k == 2 && i + 2 < polygon.count);
      const int side = vertexAt(from[k]).side;
      if (!isDiagonal && side >= kOnPlane && side < kOnPlane + kSidePlanes)
        continue; // the bounds already cut along the viewport's sides
      const WindowVertex &a = triangle.corner[k], &b = triangle.corner[k == 2 ? 0 : k + 1];
      if (a.fixedX == b.fixedX && a.fixedY == b.fixedY)
        continue;
      shape.edges[shape.edgeCount++] = part > 0 ? edgeBetween(a, b) : edgeBetween(b, a);
    }
    take(static_cast<const Triangle &>(triangle), shape);
  }
}

} // namespace arbiter::swrast
