#pragma once
#include <array>
#include <cstdint>

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
  /// Of a clipped one: corner k is weight[k] of the three vertices, rather than vertex k. Else
  /// null.
  const double (*weight)[3] = nullptr;
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

/// Twice the area in pixels of a triangle so thin that what was lost by snapping could turn it
/// over.
inline constexpr double kThinArea = 1.0 / (kSubpixels * kSubpixels);

/// The linear functions over a triangle: what a change of a value along its two sides adds per
/// pixel.
struct Gradients {
  double dx1, dx2, dy1, dy2;
  double toX, toY; ///< the origin's centre from corner 0

  [[nodiscard]] abi::Plane plane(double f0, double f1, double f2) const {
    const double d1 = f1 - f0, d2 = f2 - f0;
    if (d1 == 0 && d2 == 0)
      return {float(f0 + 0.0), 0, 0}; // what the sums below come to: -0 becomes 0
    const double dx = d1 * dx1 + d2 * dx2, dy = d1 * dy1 + d2 * dy2;
    return {float(f0 + dx * toX + dy * toY), float(dx), float(dy)};
  }
};

/// Of the triangle with these corners; its planes are exact at the centre of pixel (originX,
/// originY), in window coordinates, and round off with the distance from it.
[[nodiscard]] Gradients gradientsOf(const RasterState &state, const WindowVertex corner[3],
                                    int originX, int originY);
/// Where planes of depth begin (abi::DepthPlane): hosts' window coordinates do.
[[nodiscard]] inline int depthOriginY(const RasterState &state) {
  return state.upsideDownHeight != 0 ? state.upsideDownHeight - 1 : 0;
}
/// Window depth over a triangle by the very steps of llvmpipe (Mesa 22.3.6), in single precision
/// and from the corner of the window: of two surfaces in one plane the same one is seen at each
/// pixel, and what one of the two draws may be tested for equality by the other.
/// The corners are in the order of the primitive.
/// \param offset add polygon offset (3.5.5)
[[nodiscard]] abi::DepthPlane makeDepthPlane(const RasterState &state, const Triangle &triangle,
                                             bool offset);
/// The same along a line, by the steps of llvmpipe's lines that are not smooth.
[[nodiscard]] abi::DepthPlane makeLineDepthPlane(const RasterState &state, const WindowVertex &from,
                                                 const WindowVertex &to);
/// Depth without polygon offset, as exact as a plane of this origin can be.
[[nodiscard]] abi::DepthPlane depthPlaneOf(const RasterState &state, const WindowVertex corner[3]);
/// All planes but that of depth, of a triangle whose gradients are known.
void makePlanes(const PlanePlan &plan, const Triangle &triangle, const Gradients &gradients,
                int originX, int originY, abi::Primitive &primitive);
/// Gradients, depth and all planes of a triangle, exact at the centre of pixel (originX, originY):
/// best one near the triangle. \param offset add polygon offset to depth (3.5.5)
void makePlanes(const RasterState &state, const PlanePlan &plan, const Triangle &triangle,
                bool offset, int originX, int originY, abi::Primitive &primitive);
/// Of a point: nothing varies, all is as at corner 0 of `point`, whose `weight` is not null.
void makePointPlanes(const PlanePlan &plan, const Triangle &point, int originX, int originY,
                     abi::Primitive &primitive);
/// What polygon offset adds to depth (3.5.5).
[[nodiscard]] float depthOffset(const RasterState &state,
                                const std::array<WindowVertex, 3> &corner);

} // namespace arbiter::swrast
