#pragma once
#include <cstdint>

#include "swrast/draw_input.h"

/// Clip space to window coordinates: y up, but where RasterState::upsideDownHeight is set. Snapped
/// ones are whole numbers of 1/256 pixel, with the centre of pixel (0, 0) at the origin.
namespace arbiter::swrast {

inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixels = 1 << kSubpixelBits;
/// Rectangles and points that leave the view volume need no clipping up to here.
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
/// The viewport transform of a draw (OpenGL 1.4, 2.11.1), and which clip distances there are.
[[nodiscard]] Viewport makeViewport(const RasterState &state, const Vertices &vertices);
/// Sets the snapped coordinates from x and y, as those of triangles' corners are.
void snapVertex(WindowVertex &vertex, int upsideDownHeight);
/// Sets the vertex's window coordinates from those in clip space: `clip` is x, y, z, w with w > 0.
/// The outcode is left alone.
void toWindow(const Viewport &viewport, const float clip[4], WindowVertex &vertex);
/// The same of what cutting made: hosts round each step of it.
void cutToWindow(const Viewport &viewport, const float clip[4], WindowVertex &vertex);
/// Vertex \p index with its outcode; window coordinates are zeros where w or a value forbids them
/// (kOutW, kOutNan).
[[nodiscard]] WindowVertex windowVertex(const Viewport &viewport, const Vertices &vertices,
                                        std::uint32_t index);

} // namespace arbiter::swrast
