#pragma once
#include <array>

#include "swrast/setup/cuts.h"
#include "swrast/setup/viewport.h"

/// Clipping against the view volume and user planes.
namespace arbiter::swrast {

/// A corner of what clipping leaves.
struct ClipVertex {
  float position[4];  ///< in clip space
  float user[8];      ///< clip distances
  std::uint8_t place; ///< whose inputs it has: a place of the cuts
  WindowVertex window;
  int side; ///< what it is the first end of: a side of the triangle, kOnPlane + a plane,
            ///< kOnUserPlane
};
/// The planes of the view volume that run along the viewport's sides come first.
inline constexpr int kOnPlane = 3, kSidePlanes = 4;
/// A cut by a clip plane of the application's is a side that is drawn, unlike those of the volume.
inline constexpr int kOnUserPlane = 64;

/// A convex polygon of what is left of a triangle; at most a vertex more for each plane.
struct ClippedPolygon {
  std::array<ClipVertex, 20> vertex;
  int count = 0;
  Cuts cuts;
};
/// What is left of a triangle; `polygon.count` is less than 3 if nothing is.
/// \param corner where its vertices are in the window
void clipTriangle(const Viewport &viewport, const Vertices &vertices, const std::uint32_t index[3],
                  const WindowVertex corner[3], ClippedPolygon &polygon);
/// Two vertices of the triangle have one place: nothing of its inside is left by any cut.
[[nodiscard]] bool hasTwins(const Vertices &vertices, const std::uint32_t index[3]);

/// The ends of what is left of a line, in `end`, and how they were cut; false if nothing is.
[[nodiscard]] bool clipLine(const Viewport &viewport, const Vertices &vertices,
                            const std::uint32_t index[2], const WindowVertex corner[2],
                            ClipVertex end[2], Cuts &cuts);

} // namespace arbiter::swrast
