#pragma once
#include <algorithm>
#include <cstdlib>

#include "swrast/setup/assembly.h"
#include "swrast/setup/clip.h"
#include "swrast/setup/draw.h"
#include "swrast/setup/shape.h"

/// Triangles of a draw, one by one: assembled, clipped, culled.
namespace arbiter::swrast {

/// Which way a triangle faces. \p area twice its area in snapped units, positive if
/// counterclockwise
[[nodiscard]] inline bool isBackFacing(const RasterState &state, std::int64_t area) {
  return (area > 0) == state.frontIsClockwise;
}
/// Whether polygons that face that way are culled.
[[nodiscard]] inline bool isCulled(const RasterState &state, bool backFacing) {
  return backFacing ? state.cullBack : state.cullFront;
}

/// Fetches the corners; false if nothing of the triangle can be seen. \p any collects outcodes.
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

/// What is left of a triangle that leaves the view volume, as one shape where it has no more sides
/// than a shape has edges, else as triangles; calls `take(triangle, shape)` for each.
template <typename Take> void clipAndTake(const Draw &draw, Triangle &triangle, Take take) {
  if (hasTwins(draw.vertices, triangle.vertex))
    return;
  ClippedPolygon polygon;
  clipTriangle(draw.viewport, draw.vertices, triangle.vertex, triangle.corner, polygon);
  if (polygon.count < 3)
    return;
  // The triangle of the fan that is largest says best how inputs vary.
  WindowVertex corners[20];
  std::int64_t area = 0, largest = 0;
  int best = 1;
  for (int i = 0; i < polygon.count; ++i)
    corners[i] = polygon.vertex[std::size_t(i)].window;
  for (int i = 1; i + 1 < polygon.count; ++i) {
    const WindowVertex fan[3] = {corners[0], corners[i], corners[i + 1]};
    const std::int64_t part = areaOf(fan);
    area += part;
    if (std::abs(part) > largest) {
      largest = std::abs(part);
      best = i;
    }
  }
  if (area == 0)
    return;
  triangle.backFacing = isBackFacing(draw.state, area);
  if (isCulled(draw.state, triangle.backFacing))
    return;
  double weight[3][3];
  triangle.weight = weight;
  const auto corner = [&](int k, int from) {
    const ClipVertex &vertex = polygon.vertex[std::size_t(from)];
    triangle.corner[k] = vertex.window;
    std::copy(vertex.weight, vertex.weight + 3, weight[k]);
  };
  Shape shape;
  int edges = 0;
  for (int i = 0; i < polygon.count; ++i) {
    const ClipVertex &vertex = polygon.vertex[std::size_t(i)];
    if (vertex.side >= kOnPlane && vertex.side < kOnPlane + kSidePlanes)
      continue; // along the viewport's side: the bounds
    const WindowVertex &to = corners[i + 1 == polygon.count ? 0 : i + 1];
    if (corners[i].fixedX == to.fixedX && corners[i].fixedY == to.fixedY)
      continue;
    if (edges < 4) {
      shape.edges[edges] = area > 0 ? edgeBetween(corners[i], to) : edgeBetween(to, corners[i]);
    }
    ++edges;
  }
  const Rect clip = intersect(draw.state.clip, draw.viewport.pixels);
  if (edges <= 4) {
    if (!setBounds(clip, corners, polygon.count, shape))
      return;
    shape.edgeCount = edges;
    corner(0, 0);
    corner(1, best);
    corner(2, best + 1);
    take(static_cast<const Triangle &>(triangle), shape);
    return;
  }
  for (int i = 1; i + 1 < polygon.count; ++i) {
    corner(0, 0);
    corner(1, i);
    corner(2, i + 1);
    const std::int64_t part = areaOf(triangle.corner);
    if (part != 0 && shapeOf(clip, triangle.corner, part, shape))
      take(static_cast<const Triangle &>(triangle), shape);
  }
}

} // namespace arbiter::swrast
