#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "swrast/rasterize.h"

/// What the stages of the rasterizer hand on to each other. Window coordinates, y up; snapped ones
/// are whole numbers of 1/256 pixel, with the centre of pixel (0, 0) at the origin.
namespace arbiter::swrast {

inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixels = 1 << kSubpixelBits;
/// Rectangles that leave the view volume need no clipping up to here.
inline constexpr float kGuard = 1 << 20;

/// Why a vertex cannot be taken as it is.
enum Outcode : std::uint32_t {
  kOutLeft = 1,
  kOutRight = 2,
  kOutBottom = 4,
  kOutTop = 8,
  kOutNear = 16,
  kOutFar = 32,
  kOutW = 64,       ///< w is not positive
  kOutUser = 256,   ///< beyond the first user plane; the others follow
  kOutNan = 1 << 16 ///< a coordinate is not a number: the primitive is dropped
};
/// All vertices of a primitive beyond the same one of these: it is not seen.
inline constexpr std::uint32_t kOutsideMask = 0xFF3F;
/// Any vertex beyond one of these: the primitive must be clipped. There is no guard band: hosts
/// have none either, and cutting moves what is left of a side by a part of a sub-pixel.
inline constexpr std::uint32_t kClipMask = 0xFFFF;
inline constexpr std::uint32_t kOutSides = 15; ///< left, right, bottom, top

/// Without initial values: there are arrays of them where few are used. Two vectors of 16 bytes.
struct alignas(16) WindowVertex {
  float x;
  float y; ///< from the top down where RasterState::upsideDownHeight is set
  float z, inverseW;
  std::int32_t fixedX, fixedY;
  std::uint32_t outcode;
};

/// Clip space to window, once a draw.
struct Viewport {
  float scale[3], translate[3];
  Rect pixels; ///< whose centres are inside
  int upsideDownHeight;
  bool depthClamp;
  unsigned userPlanes; ///< clip distances that are there
};
[[nodiscard]] Viewport makeViewport(const RasterState &state, const Vertices &vertices);
/// `clip` is x, y, z, w. The outcode is left alone.
void toWindow(const Viewport &viewport, const float clip[4], WindowVertex &vertex);
[[nodiscard]] WindowVertex windowVertex(const Viewport &viewport, const Vertices &vertices,
                                        std::uint32_t index);

/// Inside where a * x + b * y + c >= 0, for pixels (x, y); the fill rule is in c.
struct Edge {
  std::int32_t a = 0, b = 0;
  std::int64_t c = 0;
};

struct Bounds {
  std::int32_t left = 0, bottom = 0, right = 0, top = 0; ///< pixels, half open, clipped
};

/// A convex region of pixels and what it is shaded with.
struct Shape : Bounds {
  std::int32_t edgeCount = 0; ///< 0: the rectangle, whole
  bool stippled = false;      ///< by the polygon stipple
  Edge edges[4];
  abi::Primitive primitive;
};

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

/// Twice the area in snapped units; positive if counterclockwise.
[[nodiscard]] inline std::int64_t areaOf(const WindowVertex corner[3]) {
  const std::int64_t ax = corner[1].fixedX - corner[0].fixedX;
  const std::int64_t ay = corner[1].fixedY - corner[0].fixedY;
  const std::int64_t bx = corner[2].fixedX - corner[0].fixedX;
  const std::int64_t by = corner[2].fixedY - corner[0].fixedY;
  return ax * by - bx * ay;
}
/// The edge from `from` to `to` of a counterclockwise polygon.
[[nodiscard]] Edge edgeBetween(const WindowVertex &from, const WindowVertex &to);
/// The first pixel whose centre is at or behind a snapped coordinate.
[[nodiscard]] constexpr std::int32_t pixelFrom(std::int32_t fixed) {
  return (fixed + kSubpixels - 1) >> kSubpixelBits;
}

/// Bounds from snapped ones; false if no pixel of the clip rectangle can be inside.
[[nodiscard]] inline bool setBounds(const Rect &clip, const WindowVertex *corner, int count,
                                    Bounds &bounds) {
  std::int32_t minX = corner[0].fixedX, maxX = minX, minY = corner[0].fixedY, maxY = minY;
  for (int i = 1; i < count; ++i) {
    minX = std::min(minX, corner[i].fixedX);
    maxX = std::max(maxX, corner[i].fixedX);
    minY = std::min(minY, corner[i].fixedY);
    maxY = std::max(maxY, corner[i].fixedY);
  }
  bounds.left = std::max(clip.x, pixelFrom(minX));
  bounds.bottom = std::max(clip.y, pixelFrom(minY));
  // A right or an upper edge is outside itself, but not a corner that a left edge ends in.
  bounds.right = std::min(clip.x + clip.width, (maxX >> kSubpixelBits) + 1);
  bounds.top = std::min(clip.y + clip.height, (maxY >> kSubpixelBits) + 1);
  return bounds.left < bounds.right && bounds.bottom < bounds.top;
}
/// Bounds and edges; false if no pixel of the clip rectangle can be inside. `area` is not 0.
[[nodiscard]] bool shapeOf(const Rect &clip, const WindowVertex corner[3], std::int64_t area,
                           Shape &shape);
/// Which planes a primitive of the draw has, and from which arrays; sorted once a draw.
struct PlanePlan {
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

/// Exact at pixel (originX, originY).
[[nodiscard]] Gradients gradientsOf(const RasterState &state, const WindowVertex corner[3],
                                    int originX, int originY);
/// `offset`: of depth.
[[nodiscard]] abi::Plane makeDepthPlane(const RasterState &state, const Triangle &triangle,
                                        const Gradients &gradients, bool offset);
/// All planes of a triangle whose gradients and depth are known.
void makePlanes(const PlanePlan &plan, const Triangle &triangle, const Gradients &gradients,
                const abi::Plane &depth, int originX, int originY, abi::Primitive &primitive);
/// The planes, exact at pixel (originX, originY), which is better near the triangle than far off.
/// `offset`: of depth.
void makePlanes(const RasterState &state, const PlanePlan &plan, const Triangle &triangle,
                bool offset, int originX, int originY, abi::Primitive &primitive);
/// Of a point: nothing varies, all is as at corner 0 of `point`, which has weights.
void makePointPlanes(const PlanePlan &plan, const Triangle &point, int originX, int originY,
                     abi::Primitive &primitive);
/// What polygon offset adds to depth (3.5.5).
[[nodiscard]] float depthOffset(const RasterState &state,
                                const std::array<WindowVertex, 3> &corner);

/// A rectangle that a draw consists of: corners in cyclic order.
struct Rectangle {
  std::uint32_t vertex[4] = {};
  std::uint32_t others[2] = {}; ///< two triangles: the second triangle's copies of shared corners
  int otherCount = 0;
  std::uint32_t otherOf[2] = {}; ///< which of the corners they are copies of
  WindowVertex corner[4];
  bool backFacing = false;
  Rect pixels; ///< clipped
};
/// False if the draw is no axis-aligned rectangle that is drawn filled, or is culled.
[[nodiscard]] bool findRectangle(const RasterState &state, Topology topology,
                                 const Vertices &vertices, const std::uint32_t *indices,
                                 std::uint32_t first, std::uint32_t count, Rectangle &rectangle);
/// One shape for all of it; false if an input is not affine over it.
[[nodiscard]] bool shapeOfRectangle(const RasterState &state, const Shading &shading,
                                    Topology topology, const Vertices &vertices,
                                    const Rectangle &rectangle, Shape &shape);

} // namespace arbiter::swrast
