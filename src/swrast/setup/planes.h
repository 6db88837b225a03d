#pragma once
#include <array>
#include <cstdint>

#include "swrast/setup/cuts.h"
#include "swrast/setup/viewport.h"

/// The planes that a primitive is shaded with: linear functions of window coordinates.
namespace arbiter::swrast {

/// A triangle of the draw before its planes are made: window positions, and how its corners follow
/// from vertices of the draw.
struct Triangle {
  WindowVertex corner[3];
  std::uint32_t vertex[3] = {};
  std::uint32_t provoking = 0;
  bool backFacing = false;
  /// Not null if the triangle was cut: corner k has the inputs of place[k] of the cuts then, rather
  /// than those of vertex k.
  const Cuts *cuts = nullptr;
  std::uint8_t place[3] = {0, 1, 2};
};

/// Which planes a primitive of the draw has, and from which arrays; sorted once a draw.
struct PlanePlan {
  PlanePlan() : wantsDepth(false), wantsW(false) {}
  PlanePlan(const Shading &shading, const Vertices &vertices);
  /// The value of vertex v is values[v & mask]: a component without an array is constant.
  struct Source {
    const float *values[2]; ///< of front and of back faces
    std::uint32_t mask[2];
    std::uint8_t input, component;
  };
  Source sources[abi::kMaxInputs * 4]; ///< Perspective ones first, then Linear, then Flat
  int linearFrom = 0, flatFrom = 0, count = 0;
  bool wantsDepth, wantsW;
};

/// Row in whose first pixel all planes begin: hosts' window coordinates do.
[[nodiscard]] inline int planesBegin(const RasterState &state) {
  return state.upsideDownHeight != 0 ? state.upsideDownHeight - 1 : 0;
}

/// Makes the planes of a triangle by the very steps of llvmpipe (Mesa 22.3.6): in single precision,
/// and from the corner of the window, so that all values are the host's to the last bit. Of two
/// surfaces in one plane the same one is seen at each pixel, what one of them draws may be tested
/// for equality by the other, and a coordinate on an edge of texels takes the host's.
class PlaneSteps {
public:
  /// \param corner in the order of hosts (HostOrder)
  PlaneSteps(const RasterState &state, const WindowVertex *const (&corner)[3]);
  /// Returns the plane of three values, given in the order of the corners.
  [[nodiscard]] abi::Plane plane(const float (&f)[3]) const;

private:
  friend abi::DepthPlane makeDepthPlane(const RasterState &, const PlaneSteps &, bool);
  const WindowVertex *m_corner[3];
  float m_x01, m_y01, m_x20, m_y20, m_inverse; ///< sides, and one divided by the area
  bool m_turns;                                ///< the host's rows go downwards
  bool m_isThin;                               ///< it has an area by its snapped corners alone
};
/// The corners of a triangle in the order in which hosts walk around it: the provoking one is the
/// first or the last, and of a piece of what was cut that is the centre of the fan. Of a triangle
/// that is clockwise to them, when its corners are snapped, two change places; the provoking one
/// stays.
struct HostOrder {
  int corner[3];
  HostOrder(const RasterState &state, const Triangle &triangle);
};
/// The same of a line that is not smooth. Values vary along its greater direction alone.
class LineSteps {
public:
  LineSteps(const RasterState &state, const WindowVertex &from, const WindowVertex &to);
  [[nodiscard]] abi::Plane plane(const float (&f)[2]) const;

private:
  float m_x, m_y, m_inverse, m_fromX, m_fromY;
  bool m_turns;
};

/// Window depth over a triangle. \param offset add polygon offset (3.5.5)
[[nodiscard]] abi::DepthPlane makeDepthPlane(const RasterState &state, const PlaneSteps &steps,
                                             bool offset);
/// Depth and all planes of a triangle. \param offset add polygon offset to depth (3.5.5)
void makePlanes(const RasterState &state, const PlanePlan &plan, const Triangle &triangle,
                bool offset, abi::Primitive &primitive);
/// All planes but that of depth. \param steps of the corners in this order
void makePlanes(const PlanePlan &plan, const Triangle &triangle, const PlaneSteps &steps,
                const int (&order)[3], abi::Primitive &primitive);
/// Depth and all planes of a line: its ends are corners 0 and 1 of `line`.
void makeLinePlanes(const RasterState &state, const PlanePlan &plan, const Triangle &line,
                    abi::Primitive &primitive);
/// Makes all planes of a point: nothing varies, and all values are those of corner 0 of `point`.
void makePointPlanes(const PlanePlan &plan, const Triangle &point, abi::Primitive &primitive);
/// What polygon offset adds to depth (3.5.5).
[[nodiscard]] float depthOffset(const RasterState &state,
                                const std::array<WindowVertex, 3> &corner);

} // namespace arbiter::swrast
