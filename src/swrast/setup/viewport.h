#pragma once
#include <cstdint>

#include "swrast/draw_input.h"

/// The viewport transform: clip space to window coordinates. y points up, unless
/// RasterState::upsideDownHeight is set. Snapped coordinates are in units of 1/256 pixel; their
/// origin is the centre of pixel (0, 0).
namespace arbiter::swrast {

inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixels = 1 << kSubpixelBits;
/// Rectangles and points that leave the view volume need no clipping within this distance.
inline constexpr float kGuard = 1 << 20;

/// Why a vertex lies outside or cannot be placed, one bit for each reason.
enum Outcode : std::uint32_t {
  kOutLeft = 1,
  kOutRight = 2,
  kOutBottom = 4,
  kOutTop = 8,
  kOutNear = 16,
  kOutFar = 32,
  kOutW = 64,       ///< w is not positive
  kOutUser = 256,   ///< outside the first user plane; the next bits are those of the others
  kOutNan = 1 << 16 ///< a coordinate is infinite or NaN: the primitive is dropped
};
/// A primitive is invisible if all its vertices have the same bit of this mask.
inline constexpr std::uint32_t kOutsideMask = 0xFF3F;
/// A primitive must be clipped if any vertex has a bit of this mask. There is no guard band,
/// because hosts have none: clipping moves what is left of a side by a fraction of a subpixel.
inline constexpr std::uint32_t kClipMask = 0xFFFF;
inline constexpr std::uint32_t kOutSides = 15; ///< left, right, bottom, top

/// A vertex in window coordinates. It has no initial values, because large arrays of it are used in
/// part. Two vectors of 16 bytes.
struct alignas(16) WindowVertex {
  float x;
  float y; ///< points down if RasterState::upsideDownHeight is set
  float z, inverseW;
  std::int32_t fixedX, fixedY;
  std::uint32_t outcode;
};

/// The viewport transform of a draw.
struct Viewport {
  float scale[3], translate[3];
  Rect pixels; ///< pixels whose centres are inside
  int upsideDownHeight;
  bool depthClamp;
  unsigned userPlanes; ///< mask of the clip distances in use
};
/// Returns the viewport transform of a draw (OpenGL 1.4, 2.11.1), with the clip distances in use.
[[nodiscard]] Viewport makeViewport(const RasterState &state, const Vertices &vertices);
/// Computes the snapped coordinates from x and y, by the rule for triangle corners.
void snapVertex(WindowVertex &vertex, int upsideDownHeight);
/// Computes a vertex's window coordinates. `clip` is x, y, z, w in clip space, with w > 0. The
/// outcode is not changed.
void toWindow(const Viewport &viewport, const float clip[4], WindowVertex &vertex);
/// Computes the window coordinates of a vertex made by clipping. Hosts round each step for these.
void cutToWindow(const Viewport &viewport, const float clip[4], WindowVertex &vertex);
/// Returns vertex \p index with its outcode. Its window coordinates are zeros if it cannot be
/// placed (kOutW, kOutNan).
[[nodiscard]] WindowVertex windowVertex(const Viewport &viewport, const Vertices &vertices,
                                        std::uint32_t index);

} // namespace arbiter::swrast
