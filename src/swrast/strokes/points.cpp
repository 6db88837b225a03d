#include <algorithm>
#include <cmath>

#include "swrast/strokes/strokes.h"

/// Points as squares: of whole pixels (3.3), or with sprites of any size and place.
namespace arbiter::swrast {
namespace {

/// Ties go away from zero, unlike those of triangles: so do the host's. As std::lround(), which is
/// a call, of what is no further from zero than kGuard.
std::int32_t snap(float value) {
  const float fixed = value * float(kSubpixels);
  const auto whole = std::int32_t(fixed);
  const float rest = fixed - float(whole);
  return whole + (rest >= 0.5f ? 1 : 0) - (rest <= -0.5f ? 1 : 0);
}

/// A sprite's in 1/256 of a pixel, another point's in pixels.
int widthOf(float size, bool sprite) {
  return sprite ? std::max(kSubpixels, snap(size))
                : std::max(1, (snap(size) + kSubpixels / 2 - 1) >> kSubpixelBits);
}

/// The pixels [first, end) along one axis, in the host's coordinates. `down`:
/// in those that run down, ties go to the neighbour.
inline void extent(float center, int width, bool sprite, bool down, int &first, int &end) {
  const std::int32_t tie = down ? 1 : 0;
  if (sprite) {
    const std::int32_t low = snap(center - 0.5f) - width / 2;
    first = pixelFrom(low + tie);
    end = pixelFrom(low + width + tie);
    return;
  }
  const std::int32_t at = snap(center) - tie + (width % 2 ? 0 : kSubpixels / 2);
  first = (at >> kSubpixelBits) - width / 2;
  end = first + width;
}

} // namespace

bool shapeOfPoint(const Draw &draw, const Stroke &stroke, const StrokeEnd &at, float size,
                  Shape &shape) {
  const RasterState &state = draw.state;
  if (!(std::fabs(at.window.x) < kGuard && std::fabs(at.window.y) < kGuard))
    return false;
  size = std::clamp(size, state.pointSizeMinimum, state.pointSizeMaximum);
  size = size > 0 ? std::min(size, 8192.0f) : 1.0f;
  const bool sprite = state.spriteInputs != 0;
  const int height = state.upsideDownHeight;
  const int width = widthOf(size, sprite);
  extent(at.window.x, width, sprite, false, shape.left, shape.right);
  extent(at.window.y, width, sprite, height != 0, shape.bottom, shape.top);
  if (height != 0) {
    const int first = shape.bottom;
    shape.bottom = height - shape.top;
    shape.top = height - first;
  }
  shape.left = std::max(shape.left, state.clip.x);
  shape.bottom = std::max(shape.bottom, state.clip.y);
  shape.right = std::min(shape.right, state.clip.x + state.clip.width);
  shape.top = std::min(shape.top, state.clip.y + state.clip.height);
  if (shape.left >= shape.right || shape.bottom >= shape.top)
    return false;
  shape.edgeCount = 0;
  shape.stippled = false;
  Triangle point;
  point.corner[0] = at.window;
  std::copy(stroke.vertex, stroke.vertex + 3, point.vertex);
  point.weight = &at.weight;
  point.provoking = stroke.provoking;
  point.backFacing = stroke.backFacing;
  makePointPlanes(draw.plan, point, shape.left, shape.bottom, shape.primitive);
  for (std::uint32_t i = 0; i < draw.shading.inputCount; ++i) {
    if (!((state.spriteInputs >> i) & 1u))
      continue;
    const bool divided = draw.shading.interpolation[i] == abi::Interpolation::Perspective;
    const float scale = divided ? at.window.inverseW : 1.0f, step = scale / size;
    const float toX = float(shape.left) + 0.5f - at.window.x;
    const float toY =
        float(shape.bottom) + 0.5f - (height != 0 ? float(height) - at.window.y : at.window.y);
    const float up = state.spriteOriginLowerLeft ? step : -step;
    abi::Plane *const input = shape.primitive.inputs[i];
    input[0] = {0.5f * scale + toX * step, step, 0};
    input[1] = {0.5f * scale + toY * up, 0, up};
    input[2] = {0, 0, 0};
    input[3] = {scale, 0, 0};
  }
  return true;
}

} // namespace arbiter::swrast
