#pragma once
#include "swrast/setup/viewport.h"

/// Many vertices to window positions at a time.
namespace arbiter::swrast {

/// What some vertices are like.
struct PlacedBounds {
  std::uint32_t outcodes = 0; ///< of all of them
  std::int32_t minX = INT32_MAX, minY = INT32_MAX, maxX = INT32_MIN, maxY = INT32_MIN; ///< snapped

  void add(const PlacedBounds &other) {
    outcodes |= other.outcodes;
    minX = minX < other.minX ? minX : other.minX;
    minY = minY < other.minY ? minY : other.minY;
    maxX = maxX > other.maxX ? maxX : other.maxX;
    maxY = maxY > other.maxY ? maxY : other.maxY;
  }
};

/// windowVertex() of the vertices [begin, end), to `window` at their numbers.
using PlaceVertices = PlacedBounds (*)(const Viewport &viewport, const Vertices &vertices,
                                       std::uint32_t begin, std::uint32_t end,
                                       WindowVertex *window);

/// One for each instruction set that pays; all give the same to the bit.
PlacedBounds placeVerticesBaseline(const Viewport &viewport, const Vertices &vertices,
                                   std::uint32_t begin, std::uint32_t end, WindowVertex *window);
PlacedBounds placeVerticesAvx2(const Viewport &viewport, const Vertices &vertices,
                               std::uint32_t begin, std::uint32_t end, WindowVertex *window);
PlacedBounds placeVerticesAvx512(const Viewport &viewport, const Vertices &vertices,
                                 std::uint32_t begin, std::uint32_t end, WindowVertex *window);
/// The best that this processor runs.
[[nodiscard]] PlaceVertices choosePlaceVertices();

/// windowVertex() of the four vertices that are named, which need not follow each other.
void placeCorners(const Viewport &viewport, const Vertices &vertices, const std::uint32_t index[4],
                  WindowVertex window[4]);

} // namespace arbiter::swrast
