#pragma once
#include <cstdint>

#include "swrast/setup/draw.h"
#include "swrast/setup/shape.h"

/// Recognises draws that are one rectangle, which 2D programs draw most.
namespace arbiter::swrast {

/// A rectangle that is a whole draw; its corners are in cyclic order.
struct Rectangle {
  std::uint32_t vertex[4] = {};
  /// for two triangles: the second one's copies of the shared corners
  std::uint32_t others[2] = {};
  int otherCount = 0;
  std::uint32_t otherOf[2] = {}; ///< the corners that they are copies of
  WindowVertex corner[4];
  bool backFacing = false;
  Rect pixels; ///< pixels inside the clip rectangle and the viewport

  /// Returns a vertex's window position. Requires that it is one of the draw's.
  [[nodiscard]] const WindowVertex &cornerOf(std::uint32_t number) const {
    for (int i = 0; i < otherCount; ++i)
      if (others[i] == number)
        return corner[otherOf[i]];
    return corner[number == vertex[0] ? 0 : number == vertex[1] ? 1 : number == vertex[2] ? 2 : 3];
  }
};
/// True if the draw is one axis-aligned, filled rectangle that is not culled; `rectangle` then
/// receives it.
/// \param indices null: vertices first, first + 1, ...; else indices[first], ...
[[nodiscard]] bool findRectangle(const RasterState &state, Topology topology,
                                 const Vertices &vertices, const std::uint32_t *indices,
                                 std::uint32_t first, std::uint32_t count, Rectangle &rectangle);
/// Makes one shape of the rectangle, or two triangles if their planes differ in any bit. Returns
/// the number of shapes, or 0 if the rectangle must be clipped as triangles.
/// \param draw its vertices need not be placed
[[nodiscard]] int shapesOfRectangle(const Draw &draw, const Rectangle &rectangle,
                                    Shape (&shapes)[2]);

/// Returns the pixels that a simple draw certainly overwrites, or an empty rectangle if that is not
/// known. A draw is simple if it is a quad, two triangles, or a strip or fan of four vertices. Uses
/// positions and state only.
[[nodiscard]] Rect surelyCovered(const RasterState &state, Topology topology,
                                 const Vertices &vertices, const std::uint32_t *indices,
                                 std::uint32_t first, std::uint32_t count);
/// Returns how non-flat inputs vary: Perspective, Even if all w are the same, or Linear if dividing
/// by w and multiplying again is exact too.
[[nodiscard]] abi::Interpolation interpolationOf(const Vertices &vertices);

} // namespace arbiter::swrast
