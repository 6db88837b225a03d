#include "swrast/setup/place_draw.h"

#include <algorithm>

#include "swrast/setup/assembly.h"
#include "swrast/setup/shape.h"
#include "swrast/threads.h"

namespace arbiter::swrast {
namespace {

/// Finds the range [begin, end) of vertices that the draw uses.
void usedVertices(const Draw &draw, std::uint32_t &begin, std::uint32_t &end) {
  begin = draw.first;
  end = draw.first + draw.count;
  if (!draw.indices)
    return;
  // Branch-free, and with signed numbers, because all processors have vector comparisons for those.
  // Invalid indices are replaced by the buffer's end or by -1.
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

} // namespace

std::uint32_t drawnCount(const DrawArguments &draw) {
  if (draw.state.clip.empty() || (!draw.shading.row && !draw.shading.quad))
    return 0;
  if (draw.indices)
    return draw.count;
  return draw.first < draw.vertices.count ? std::min(draw.count, draw.vertices.count - draw.first)
                                          : 0;
}

Draw drawOf(const DrawArguments &arguments) {
  return {arguments, makeViewport(arguments.state, arguments.vertices),
          PlanePlan(arguments.shading, arguments.vertices)};
}

void placeVertices(Draw &draw, std::vector<WindowVertex> &window,
                   std::vector<PlacedBounds> &bounds) {
  std::uint32_t begin = 0, end = 0;
  usedVertices(draw, begin, end);
  draw.visible = draw.bounds = intersect(draw.state.clip, draw.viewport.pixels);
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
  const bool clipped = draw.isClipped = (all.outcodes & (kClipMask | kOutNan)) != 0;
  draw.otherDiagonal = cutsOtherwise(draw.state, draw.topology, clipped);
  if (clipped)
    return; // vertices outside the view volume have no position to bound anything with
  const std::int32_t left = pixelFrom(all.minX), bottom = pixelFrom(all.minY);
  draw.visible = intersect(draw.visible, {left, bottom, (all.maxX >> kSubpixelBits) + 1 - left,
                                          (all.maxY >> kSubpixelBits) + 1 - bottom});
}

} // namespace arbiter::swrast
