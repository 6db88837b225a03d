#pragma once
#include <array>
#include <cstdint>

#include "swrast/setup/cuts.h"
#include "swrast/setup/viewport.h"

/// Computes the planes of a primitive: depth, 1/w and inputs as linear functions of window
/// coordinates.
namespace arbiter::swrast {

/// A triangle of the draw, before its planes are computed. It has window positions, and tells which
/// vertices of the draw its corners come from.
struct Triangle {
  WindowVertex corner[3];
  std::uint32_t vertex[3] = {};
  std::uint32_t provoking = 0;
  bool backFacing = false;
  /// Set if the triangle was clipped. Corner k then has the inputs of place[k] of the cuts, not
  /// those of vertex k.
  const Cuts *cuts = nullptr;
  std::uint8_t place[3] = {0, 1, 2};
};

/// Tells which planes the primitives of a draw need, and from which arrays. It is made once for
/// each draw.
struct PlanePlan {
  PlanePlan() : wantsDepth(false), wantsW(false) {}
  PlanePlan(const Shading &shading, const Vertices &vertices);
  /// The value of vertex v is values[v & mask]. The mask is 0 for a component without an array,
  /// which is constant.
  struct Source {
    const float *values[2]; ///< for front and for back faces
    std::uint32_t mask[2];
    std::uint8_t input, component;
  };
  Source sources[abi::kMaxInputs * 4]; ///< in the order Perspective, Linear, Flat
  int linearFrom = 0, flatFrom = 0, count = 0;
  bool wantsDepth, wantsW;
};

/// Returns the row at whose first pixel all planes begin, as in hosts' window coordinates.
[[nodiscard]] inline int planesBegin(const RasterState &state) {
  return state.upsideDownHeight != 0 ? state.upsideDownHeight - 1 : 0;
}

/// Computes a triangle's planes by the exact steps of llvmpipe (Mesa 22.3.6): in single precision,
/// from the window's corner. All values then match the host's to the last bit. Of two coplanar
/// surfaces the same one is visible at each pixel, later passes may test its depths for equality,
/// and coordinates on texel edges select the host's texel.
class PlaneSteps {
public:
  /// \param corner in the hosts' order (HostOrder)
  PlaneSteps(const RasterState &state, const WindowVertex *const (&corner)[3]);
  /// Returns the plane through three values, in the order of the corners.
  [[nodiscard]] abi::Plane plane(const float (&f)[3]) const;

private:
  friend abi::DepthPlane makeDepthPlane(const RasterState &, const PlaneSteps &, bool);
  const WindowVertex *m_corner[3];
  float m_x01, m_y01, m_x20, m_y20, m_inverse; ///< sides, and the reciprocal of the area
  bool m_turns;                                ///< true if the host's rows run downwards
  bool m_isThin;                               ///< true if only the snapped corners have an area
};
/// The corners of a triangle in the order of hosts. The provoking corner is the first or the last.
/// For a piece of a clipped polygon, it is the centre of the fan. If the snapped triangle is
/// clockwise to the host, the two other corners are swapped.
struct HostOrder {
  int corner[3];
  HostOrder(const RasterState &state, const Triangle &triangle);
};
/// Computes the planes of a line that is not smooth, by the steps of hosts. Values vary along the
/// line's major direction alone.
class LineSteps {
public:
  LineSteps(const RasterState &state, const WindowVertex &from, const WindowVertex &to);
  [[nodiscard]] abi::Plane plane(const float (&f)[2]) const;

private:
  float m_x, m_y, m_inverse, m_fromX, m_fromY;
  bool m_turns;
};

/// Computes the plane of window depth over a triangle. \param offset adds polygon offset (3.5.5)
[[nodiscard]] abi::DepthPlane makeDepthPlane(const RasterState &state, const PlaneSteps &steps,
                                             bool offset);
/// Computes depth and all planes of a triangle. \param offset adds polygon offset to depth (3.5.5)
void makePlanes(const RasterState &state, const PlanePlan &plan, const Triangle &triangle,
                bool offset, abi::Primitive &primitive);
/// Computes all planes but that of depth. \param steps made from the corners in `order`
void makePlanes(const PlanePlan &plan, const Triangle &triangle, const PlaneSteps &steps,
                const int (&order)[3], abi::Primitive &primitive);
/// Computes depth and all planes of a line, whose ends are corners 0 and 1 of `line`.
void makeLinePlanes(const RasterState &state, const PlanePlan &plan, const Triangle &line,
                    abi::Primitive &primitive);
/// Computes depth and all planes of a point. All of them are constant, with the values of corner 0
/// of `point`.
void makePointPlanes(const PlanePlan &plan, const Triangle &point, abi::Primitive &primitive);
/// Returns the polygon offset that is added to depth (3.5.5).
[[nodiscard]] float depthOffset(const RasterState &state,
                                const std::array<WindowVertex, 3> &corner);

} // namespace arbiter::swrast
