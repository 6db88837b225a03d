#include "swrast/rasterize.h"

#include <algorithm>
#include <cstdint>
#include <new>

#include "swrast/cover/bins.h"
#include "swrast/cover/direct.h"
#include "swrast/setup/place.h"
#include "swrast/setup/rectangle.h"
#include "swrast/strokes/strokes.h"
#include "swrast/threads.h"
#include "util/per_thread.h"

namespace arbiter::swrast {
namespace {

/// Draws of no more triangles are shaded in bands: sorting them would not pay.
constexpr std::uint32_t kDirectTriangles = 32;

/// Kept by each thread that draws, so that a draw like the last one allocates nothing.
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

/// The vertices that the draw uses: [begin, end).
void usedVertices(const Draw &draw, std::uint32_t &begin, std::uint32_t &end) {
  begin = draw.first;
  end = draw.first + draw.count;
  if (!draw.indices)
    return;
  // Without a branch, and of signed numbers, which all processors compare in vectors: an index that
  // is too great is taken for the end of the buffer.
  const auto bufferEnd = std::int32_t(std::min(draw.vertices.count, std::uint32_t(INT32_MAX)));
  std::int32_t first = bufferEnd, last = -1;
  for (std::uint32_t i = 0; i < draw.count; ++i) {
    const auto index = std::int32_t(draw.indices[i]);
    const bool isGood = index >= 0 && index < bufferEnd;
    first = std::min(first, isGood ? index : bufferEnd);
    last = std::max(last, isGood ? index : -1);
  }
  begin = std::uint32_t(first);
  end = std::uint32_t(last + 1);
}

/// Window positions of the vertices that are used, and what can be seen of their primitives.
void placeVertices(Draw &draw, std::vector<WindowVertex> &window,
                   std::vector<PlacedBounds> &bounds) {
  std::uint32_t begin = 0, end = 0;
  usedVertices(draw, begin, end);
  draw.visible = intersect(draw.state.clip, draw.viewport.pixels);
  if (window.size() < end)
    window.resize(end);
  draw.window = window.data();
  if (begin >= end)
    return;
  constexpr std::uint32_t kStretch = Vertices::kStretch;
  const std::uint32_t firstStretch = begin / kStretch;
  const std::uint32_t chunks = (end + kStretch - 1) / kStretch - firstStretch;
  bounds.assign(chunks, {});
  const PlaceVertices place = choosePlaceVertices();
  auto chunk = [&](std::uint32_t number) {
    const std::uint32_t from = (firstStretch + number) * kStretch;
    const std::uint32_t to = std::min(end, from + kStretch);
    if (draw.vertices.make)
      draw.vertices.make(draw.vertices.maker, from, to);
    bounds[number] = place(draw.viewport, draw.vertices, std::max(begin, from), to, window.data());
  };
  parallel(chunks, chunk);
  PlacedBounds all;
  for (const PlacedBounds &part : bounds)
    all.add(part);
  const bool clipped = (all.outcodes & (kClipMask | kOutNan)) != 0;
  // Hosts clip and stipple in another path than the plain one, and it cuts quads otherwise. The
  // plain one does so too where it hands on the first vertex as the provoking one.
  draw.otherDiagonal = draw.state.secondDiagonal || draw.state.polygonStipple != nullptr ||
                       clipped || draw.state.provokingIsFirst;
  if (clipped)
    return; // a vertex that is outside has no place that bounds anything
  const std::int32_t left = pixelFrom(all.minX), bottom = pixelFrom(all.minY);
  draw.visible = intersect(draw.visible, {left, bottom, (all.maxX >> kSubpixelBits) + 1 - left,
                                          (all.maxY >> kSubpixelBits) + 1 - bottom});
}

DrawStatistics drawFewTriangles(const Draw &draw, std::vector<Shape> &shapes,
                                std::uint32_t triangles) {
  shapes.clear();
  const RasterState &state = draw.state;
  const auto take = [&](const Triangle &triangle, Shape &shape) {
    shape.stippled = state.polygonStipple != nullptr;
    makePlanes(state, draw.plan, triangle, state.offsetFill, shape.left, shape.bottom,
               shape.primitive);
    shapes.push_back(shape);
  };
  for (std::uint32_t i = 0; i < triangles; ++i) {
    Triangle triangle;
    std::uint32_t any = 0;
    if (!fetchTriangle(draw,
                       triangleAt(draw.topology, draw.count, i, provokesFirst(state, draw.topology),
                                  draw.otherDiagonal),
                       triangle, any))
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

static DrawStatistics drawChecked(const RasterState &state, const Shading &shading,
                                  Topology topology, const Vertices &vertices,
                                  const std::uint32_t *indices, std::uint32_t first,
                                  std::uint32_t count) {
  if (state.clip.empty() || (!shading.row && !shading.quad) || count == 0)
    return {};
  if (!indices) {
    if (first >= vertices.count)
      return {};
    count = std::min(count, vertices.count - first);
  }
  Rectangle rectangle;
  if (isPolygonal(topology) &&
      findRectangle(state, topology, vertices, indices, first, count, rectangle)) {
    if (rectangle.pixels.empty())
      return {};
    Shape shape;
    if (shapeOfRectangle(state, shading, topology, vertices, rectangle, shape))
      return {1, shadeInBands(state, shading, &shape, 1)};
  }
  Draw all = {state,
              shading,
              topology,
              vertices,
              indices,
              first,
              count,
              makeViewport(state, vertices),
              PlanePlan(shading, vertices)};
  placeVertices(all, scratch().window, scratch().bounds);
  if (isPolygonal(topology) && all.isFilled())
    return drawTriangles(all);
  DrawStatistics statistics;
  scratch().strokes.rasterize(all, statistics);
  return statistics;
}

DrawStatistics rasterize(const RasterState &state, const Shading &shading, Topology topology,
                         const Vertices &vertices, const std::uint32_t *indices,
                         std::uint32_t first, std::uint32_t count) {
  OwnScratch::lend(); // the other threads read it
  DrawStatistics statistics;
  try {
    statistics = drawChecked(state, shading, topology, vertices, indices, first, count);
  } catch (const std::bad_alloc &) {
    statistics = {.incomplete = true};
  }
  OwnScratch::takeBack();
  return statistics;
}

} // namespace arbiter::swrast
