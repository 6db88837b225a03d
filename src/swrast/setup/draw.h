#pragma once
#include "swrast/setup/planes.h"

/// The data that all stages of one draw share.
namespace arbiter::swrast {

/// The arguments of rasterize(), and what they refer to.
struct DrawArguments {
  const RasterState &state;
  const Shading &shading;
  Topology topology;
  const Vertices &vertices;
  const std::uint32_t *indices;
  std::uint32_t first, count;
};

struct Draw : DrawArguments {
  Viewport viewport;
  PlanePlan plan;
  const WindowVertex *window = nullptr; ///< window positions of all vertices that the draw uses
  Rect bounds;                          ///< intersection of scissor, target and viewport
  Rect visible;                         ///< pixels that the draw may reach
  bool otherDiagonal = false;           ///< for quads, see triangleAt()
  bool isClipped = false; ///< true if a vertex of the draw lies outside the view volume
  /// For triangles by indices: position of the first triangle's provoking vertex; those of the next
  /// triangles follow it. 0: as RasterState says.
  std::uint32_t provokingAt = 0;

  [[nodiscard]] std::uint32_t vertexAt(std::uint32_t place) const {
    return indices ? indices[place] : first + place;
  }
  /// Returns the polygon mode of a face. A culled face takes the other face's mode, so that an
  /// invisible mode has no effect. This decides how quads are split; hosts make an exception for
  /// points.
  [[nodiscard]] PolygonMode modeOf(bool backFacing) const {
    const PolygonMode own = backFacing ? state.back : state.front;
    const PolygonMode other = backFacing ? state.front : state.back;
    const bool culled = backFacing ? state.cullBack : state.cullFront;
    return culled && own != PolygonMode::Point ? other : own;
  }
  [[nodiscard]] bool isFilled() const {
    return modeOf(false) == PolygonMode::Fill && modeOf(true) == PolygonMode::Fill;
  }
};

} // namespace arbiter::swrast
