#pragma once
#include <cstdint>

#include "swrast/setup/draw.h"
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
  Rect pixels; ///< clipped

  /// Returns a vertex's place in the window. Requires: it is one of the draw's.
  [[nodiscard]] const WindowVertex &cornerOf(std::uint32_t number) const {
    for (int i = 0; i < otherCount; ++i)
      if (others[i] == number)
        return corner[otherOf[i]];
    return corner[number == vertex[0] ? 0 : number == vertex[1] ? 1 : number == vertex[2] ? 2 : 3];
  }
};
/// Whether the draw is one axis-aligned rectangle that is drawn filled and is not culled; then
/// `rectangle` says which.
/// \param indices null: vertices first, first + 1, ...; else indices[first], ...
[[nodiscard]] bool findRectangle(const RasterState &state, Topology topology,
                                 const Vertices &vertices, const std::uint32_t *indices,
                                 std::uint32_t first, std::uint32_t count, Rectangle &rectangle);
/// The rectangle as one shape, or as its two triangles where these do not have the same planes to
/// the last bit; returns how many, and 0 where it is to be cut as other triangles are.
/// \param draw nothing of it is placed
[[nodiscard]] int shapesOfRectangle(const Draw &draw, const Rectangle &rectangle,
                                    Shape (&shapes)[2]);

/// The region that the draw surely overwrites whole, if it is as simple as a rectangle (a quad, two
/// triangles, a strip or fan of four): else empty. Needs no more than positions and state.
[[nodiscard]] Rect surelyCovered(const RasterState &state, Topology topology,
                                 const Vertices &vertices, const std::uint32_t *indices,
                                 std::uint32_t first, std::uint32_t count);
/// How inputs vary that are not flat: Perspective, or Even where all w are the same, or Linear
/// where they are such that a division by them and a multiplication do not round.
[[nodiscard]] abi::Interpolation interpolationOf(const Vertices &vertices);

} // namespace arbiter::swrast
