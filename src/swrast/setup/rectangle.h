#pragma once
#include <cstdint>

#include "swrast/setup/shape.h"

/// Draws that are one rectangle, the commonest of all draws of 2D programs.
namespace arbiter::swrast {

/// A rectangle that a draw consists of: corners in cyclic order.
struct Rectangle {
  std::uint32_t vertex[4] = {};
  std::uint32_t others[2] = {}; ///< two triangles: the second triangle's copies of shared corners
  int otherCount = 0;
  std::uint32_t otherOf[2] = {}; ///< which of the corners they are copies of
  WindowVertex corner[4];
  bool backFacing = false;
  std::int32_t left = 0, bottom = 0; ///< pixels, not clipped
  Rect pixels;                       ///< clipped
};
/// Whether the draw is one axis-aligned rectangle that is drawn filled and is not culled; then
/// `rectangle` says which.
/// \param indices null: vertices first, first + 1, ...; else indices[first], ...
[[nodiscard]] bool findRectangle(const RasterState &state, Topology topology,
                                 const Vertices &vertices, const std::uint32_t *indices,
                                 std::uint32_t first, std::uint32_t count, Rectangle &rectangle);
/// The rectangle as one shape, in place of two triangles; false if an input is no linear function
/// over the whole of it (the fourth corner's value is not what the other three's make it).
[[nodiscard]] bool shapeOfRectangle(const RasterState &state, const Shading &shading,
                                    Topology topology, const Vertices &vertices,
                                    const Rectangle &rectangle, Shape &shape);

/// The region that the draw surely overwrites whole, if it is as simple as a rectangle (a quad, two
/// triangles, a strip or fan of four): else empty. Needs no more than positions and state.
[[nodiscard]] Rect surelyCovered(const RasterState &state, Topology topology,
                                 const Vertices &vertices, const std::uint32_t *indices,
                                 std::uint32_t first, std::uint32_t count);
/// All w are equal: perspective changes nothing, so that inputs may be Linear.
[[nodiscard]] bool isAffine(const Vertices &vertices);

} // namespace arbiter::swrast
