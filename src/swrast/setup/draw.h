#pragma once
#include "swrast/setup/planes.h"

/// What the stages of one draw look at and keep.
namespace arbiter::swrast {

struct Draw {
  const RasterState &state;
  const Shading &shading;
  Topology topology;
  const Vertices &vertices;
  const std::uint32_t *indices;
  std::uint32_t first, count;
  Viewport viewport;
  PlanePlan plan;
  const WindowVertex *window = nullptr; ///< of all vertices that the draw uses
  Rect bounds;                          ///< scissor, target and viewport, intersected
  Rect visible;                         ///< pixels that the draw may reach
  bool otherDiagonal = false;           ///< of quads: see triangleAt()
  bool isClipped = false;               ///< a vertex that the draw uses lies outside
  /// Of Triangles by indices: the place of the first one's provoking vertex, which those of the
  /// others follow; 0: as the state has it.
  std::uint32_t provokingAt = 0;

  [[nodiscard]] std::uint32_t vertexAt(std::uint32_t place) const {
    return indices ? indices[place] : first + place;
  }
  /// A face that is culled has the other's mode, so that no mode that is not seen is asked for.
  /// That decides how quads are cut; points are the exception that hosts make.
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
