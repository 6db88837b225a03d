#pragma once
#include <array>

#include "swrast/setup/cuts.h"
#include "swrast/setup/viewport.h"

/// Clips primitives against the view volume and user clip planes.
namespace arbiter::swrast {

/// A corner of a clipped polygon.
struct ClipVertex {
  float position[4];  ///< in clip space
  float user[8];      ///< clip distances
  std::uint8_t place; ///< index into Cuts: the vertex or cut whose inputs this has
  WindowVertex window;
  /// the line that the side which begins here lies on: a side of the triangle, kOnPlane + a plane,
  /// or kOnUserPlane
  int side;
};
/// Planes of the view volume are numbered from kOnPlane on. The first kSidePlanes of them run along
/// the viewport's sides.
inline constexpr int kOnPlane = 3, kSidePlanes = 4;
/// A cut by a user clip plane. Unlike a cut by the view volume, it is a side that is drawn.
inline constexpr int kOnUserPlane = 64;

/// The rest of a triangle after clipping: a convex polygon, with at most one vertex more for each
/// plane.
struct ClippedPolygon {
  std::array<ClipVertex, 20> vertex;
  int count = 0;
  Cuts cuts;
};
/// Clips a triangle. `polygon.count` is less than 3 if nothing is left.
/// \param corner window positions of its vertices
void clipTriangle(const Viewport &viewport, const Vertices &vertices, const std::uint32_t index[3],
                  const WindowVertex corner[3], ClippedPolygon &polygon);
/// True if two vertices of the triangle have the same position, so that any clipping leaves no
/// area.
[[nodiscard]] bool hasTwins(const Vertices &vertices, const std::uint32_t index[3]);

/// Clips a line. Returns false if nothing is left.
/// \param end receives the ends
/// \param cuts receives how they were cut
[[nodiscard]] bool clipLine(const Viewport &viewport, const Vertices &vertices,
                            const std::uint32_t index[2], const WindowVertex corner[2],
                            ClipVertex end[2], Cuts &cuts);

} // namespace arbiter::swrast
