#pragma once
#include "swrast/setup/viewport.h"

/// Transforms many vertices to window positions at a time.
namespace arbiter::swrast {

/// The combined outcodes and window bounds of some vertices.
struct PlacedBounds {
  std::uint32_t outcodes = 0; ///< union of all outcodes
  /// snapped coordinates
  std::int32_t minX = INT32_MAX, minY = INT32_MAX, maxX = INT32_MIN, maxY = INT32_MIN;

  void add(const PlacedBounds &other) {
    outcodes |= other.outcodes;
    minX = minX < other.minX ? minX : other.minX;
    minY = minY < other.minY ? minY : other.minY;
    maxX = maxX > other.maxX ? maxX : other.maxX;
    maxY = maxY > other.maxY ? maxY : other.maxY;
  }
};

/// Computes windowVertex() for vertices [begin, end), and stores each in `window` at its index.
using PlaceVertices = PlacedBounds (*)(const Viewport &viewport, const Vertices &vertices,
                                       std::uint32_t begin, std::uint32_t end,
                                       WindowVertex *window);

/// One function for each useful instruction set. All give the same bits.
PlacedBounds placeVerticesBaseline(const Viewport &viewport, const Vertices &vertices,
                                   std::uint32_t begin, std::uint32_t end, WindowVertex *window);
PlacedBounds placeVerticesAvx2(const Viewport &viewport, const Vertices &vertices,
                               std::uint32_t begin, std::uint32_t end, WindowVertex *window);
PlacedBounds placeVerticesAvx512(const Viewport &viewport, const Vertices &vertices,
                                 std::uint32_t begin, std::uint32_t end, WindowVertex *window);
/// Returns the best function for this processor.
[[nodiscard]] PlaceVertices choosePlaceVertices();

/// Computes windowVertex() for four vertices, given by their indices.
void placeCorners(const Viewport &viewport, const Vertices &vertices, const std::uint32_t index[4],
                  WindowVertex window[4]);

} // namespace arbiter::swrast
