#pragma once
#include "swrast/assembly.h"
#include "swrast/scratch.h"

/// Triangles of a draw, one by one: assembled, clipped, culled.
namespace arbiter::swrast {

/// Which way a triangle faces, and whether that is culled.
[[nodiscard]] inline bool isBackFacing(const RasterState &state, std::int64_t area) {
  return (area > 0) == state.frontIsClockwise;
}
[[nodiscard]] inline bool isCulled(const RasterState &state, bool backFacing) {
  return backFacing ? state.cullBack : state.cullFront;
}

/// Calls `take(triangle, area)` for what is left of a triangle: nothing, one, or after clipping
/// several. `corners` are places in the draw.
template <typename Take>
void forTriangle(const Draw &draw, const TriangleCorners &corners, Take take) {
  Triangle triangle;
  std::uint32_t all = ~0u, any = 0;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t index = draw.vertexAt(corners.corner[k]);
    if (index >= draw.vertices.count)
      return;
    triangle.vertex[k] = index;
    triangle.corner[k] = windowVertex(draw.viewport, draw.vertices, index);
    all &= triangle.corner[k].outcode;
    any |= triangle.corner[k].outcode;
  }
  triangle.provoking = draw.vertexAt(corners.provoking);
  if ((all & kOutsideMask) || (any & kOutNan) || triangle.provoking >= draw.vertices.count)
    return;
  const auto give = [&] {
    const std::int64_t area = areaOf(triangle.corner);
    if (area == 0)
      return;
    triangle.backFacing = isBackFacing(draw.state, area);
    if (!isCulled(draw.state, triangle.backFacing))
      take(static_cast<const Triangle &>(triangle), area);
  };
  if (!(any & kClipMask)) {
    give();
    return;
  }
  ClippedPolygon polygon;
  clipTriangle(draw.viewport, draw.vertices, triangle.vertex, polygon);
  triangle.clipped = true;
  for (int i = 2; i < polygon.count; ++i) {
    const int corner[3] = {0, i - 1, i};
    for (int k = 0; k < 3; ++k) {
      const ClipVertex &vertex = polygon.vertex[std::size_t(corner[k])];
      triangle.corner[k] = vertex.window;
      std::copy(vertex.weight, vertex.weight + 3, triangle.weight[k]);
    }
    give();
  }
}

} // namespace arbiter::swrast
