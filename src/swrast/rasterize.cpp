#include "swrast/rasterize.h"

#include <algorithm>
#include <cstdint>
#include <new>

#include "swrast/cover/bins.h"
#include "swrast/cover/direct.h"
#include "swrast/setup/place_draw.h"
#include "swrast/setup/rectangle.h"
#include "swrast/strokes/strokes.h"
#include "swrast/threads.h"
#include "util/per_thread.h"

namespace arbiter::swrast {
namespace {

/// Up to this many triangles are shaded in bands: sorting them into tiles would cost more.
constexpr std::uint32_t kDirectTriangles = 32;

/// Buffers that each drawing thread keeps, so that repeated draws allocate nothing.
struct Scratch {
  std::vector<WindowVertex> window;
  std::vector<PlacedBounds> bounds;
  std::vector<Shape> shapes;
  Bins bins;
  Strokes strokes;
};
using OwnScratch = PerThread<Scratch, Scratch>;
Scratch &scratch() {
  if (Scratch *const own = OwnScratch::get()) [[likely]]
    return *own;
  throw std::bad_alloc();
}

DrawStatistics drawFewTriangles(const Draw &draw, std::vector<Shape> &shapes,
                                std::uint32_t triangles) {
  shapes.clear();
  const RasterState &state = draw.state;
  const auto take = [&](const Triangle &triangle, Shape &shape) {
    shape.stippled = state.polygonStipple != nullptr;
    makePlanes(state, draw.plan, triangle, state.offsetFill, shape.primitive);
    shapes.push_back(shape);
  };
  for (std::uint32_t i = 0; i < triangles; ++i) {
    Triangle triangle;
    std::uint32_t any = 0;
    TriangleCorners corners = triangleAt(draw.topology, draw.count, i,
                                         provokesFirst(state, draw.topology), draw.otherDiagonal);
    if (draw.provokingAt != 0)
      corners.provoking = draw.provokingAt + i;
    if (!fetchTriangle(draw, corners, triangle, any))
      continue;
    if (any & kClipMask) {
      clipAndTake(draw, triangle, take);
      continue;
    }
    const std::int64_t area = areaOf(triangle.corner);
    triangle.backFacing = isBackFacing(state, area);
    Shape shape;
    if (area != 0 && !isCulled(state, triangle.backFacing) &&
        shapeOf(draw.visible, triangle.corner, area, shape))
      take(triangle, shape);
  }
  return {shapes.size(), shadeInBands(state, draw.shading, shapes.data(), shapes.size())};
}

DrawStatistics drawTriangles(const Draw &draw) {
  const std::uint32_t triangles = triangleCount(draw.topology, draw.count);
  if (triangles <= kDirectTriangles)
    return drawFewTriangles(draw, scratch().shapes, triangles);
  DrawStatistics result;
  for (std::uint32_t i = 0; i < triangles; i += Bins::kMaxTriangles)
    scratch().bins.shade(draw, i, std::min(Bins::kMaxTriangles, triangles - i), result);
  return result;
}

} // namespace

static DrawStatistics drawChecked(DrawArguments draw, std::uint32_t provokingAt) {
  draw.count = drawnCount(draw);
  if (draw.count == 0)
    return {};
  Rectangle rectangle;
  if (provokingAt == 0 && isPolygonal(draw.topology) &&
      findRectangle(draw.state, draw.topology, draw.vertices, draw.indices, draw.first, draw.count,
                    rectangle)) {
    if (rectangle.pixels.empty())
      return {};
  }
  Draw all = drawOf(draw);
  Shape shapes[2];
  const int parts = rectangle.pixels.empty() ? 0 : shapesOfRectangle(all, rectangle, shapes);
  if (parts != 0)
    return {std::uint64_t(parts),
            shadeInBands(draw.state, draw.shading, shapes, std::size_t(parts))};
  all.provokingAt = provokingAt;
  placeVertices(all, scratch().window, scratch().bounds);
  if (isPolygonal(draw.topology) && all.isFilled())
    return drawTriangles(all);
  DrawStatistics statistics;
  scratch().strokes.rasterize(all, statistics);
  return statistics;
}

DrawStatistics rasterize(const RasterState &state, const Shading &shading, Topology topology,
                         const Vertices &vertices, const std::uint32_t *indices,
                         std::uint32_t first, std::uint32_t count, std::uint32_t provokingAt) {
  OwnScratch::lend(); // the worker threads read the scratch buffers
  DrawStatistics statistics;
  try {
    statistics =
        drawChecked({state, shading, topology, vertices, indices, first, count}, provokingAt);
  } catch (const std::bad_alloc &) {
    statistics = {.incomplete = true};
  }
  OwnScratch::takeBack();
  return statistics;
}

} // namespace arbiter::swrast
