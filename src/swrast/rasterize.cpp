#include "swrast/rasterize.h"

#include "swrast/direct.h"
#include "swrast/triangles.h"

namespace arbiter::swrast {
namespace {

Scratch &scratch() {
  thread_local Scratch instance;
  return instance;
}

/// Shapes that are kept before they are shaded.
constexpr std::size_t kMaxShapes = 256;

DrawStatistics drawTriangles(const Draw &draw) {
  DrawStatistics result;
  std::vector<Shape> &shapes = scratch().shapes;
  shapes.clear();
  const auto shadeAll = [&] {
    result.primitives += shapes.size();
    result.pixels += shadeInBands(draw.state, draw.shading, shapes.data(), shapes.size());
    shapes.clear();
  };
  const std::uint32_t triangles = triangleCount(draw.topology, draw.count);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const TriangleCorners corners =
        triangleAt(draw.topology, draw.count, i, draw.state.provokingIsFirst);
    forTriangle(draw, corners, [&](const Triangle &triangle, std::int64_t area) {
      if (draw.modeOf(triangle.backFacing) != PolygonMode::Fill)
        return;
      Shape &shape = shapes.emplace_back();
      if (!shapeOf(draw.state, triangle, area, shape)) {
        shapes.pop_back();
        return;
      }
      shape.stippled = draw.state.polygonStipple != nullptr;
      makePlanes(draw.shading, draw.vertices, triangle, draw.state, draw.state.offsetFill, shape);
    });
    if (shapes.size() >= kMaxShapes)
      shadeAll();
  }
  shadeAll();
  return result;
}

} // namespace

DrawStatistics draw(const RasterState &state, const Shading &shading, Topology topology,
                    const Vertices &vertices, const std::uint32_t *indices, std::uint32_t first,
                    std::uint32_t count) {
  if (state.clip.empty() || (!shading.row && !shading.quad))
    return {};
  Rectangle rectangle;
  if (isPolygonal(topology) &&
      findRectangle(state, topology, vertices, indices, first, count, rectangle)) {
    if (rectangle.pixels.empty())
      return {};
    Shape shape;
    if (shapeOfRectangle(state, shading, topology, vertices, rectangle, shape))
      return {1, shadeInBands(state, shading, &shape, 1)};
  }
  const Draw all = {state,   shading, topology, vertices,
                    indices, first,   count,    makeViewport(state, vertices)};
  if (isPolygonal(topology))
    return drawTriangles(all);
  return {};
}

} // namespace arbiter::swrast
