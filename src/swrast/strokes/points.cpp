#include <algorithm>
#include <cmath>

#include "swrast/strokes/strokes.h"

/// Draws points: as squares of whole pixels (3.3), as sprites of any size and position, or, if
/// smooth, as discs.
namespace arbiter::swrast {
namespace {

/// Snaps to 1/256 pixel and rounds ties away from zero, as the host does for points. It equals
/// std::lround(), which would be a function call, for values up to kGuard.
std::int32_t snap(float value) {
  const float fixed = value * float(kSubpixels);
  const auto whole = std::int32_t(fixed);
  const float rest = fixed - float(whole);
  return whole + (rest >= 0.5f ? 1 : 0) - (rest <= -0.5f ? 1 : 0);
}

/// Returns a sprite's width in 1/256 of a pixel, or another point's in pixels.
int widthOf(float size, bool sprite) {
  return sprite ? std::max(kSubpixels, snap(size))
                : std::max(1, (snap(size) + kSubpixels / 2 - 1) >> kSubpixelBits);
}

/// Computes the pixels [first, end) along one axis, in the host's coordinates. If `down` is true
/// the axis points down, and ties go to the neighbouring pixel.
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

/// Returns the point's size, clamped to the supported range.
float sizeWithin(const RasterState &state, float size) {
  size = std::clamp(size, state.pointSizeMinimum, state.pointSizeMaximum);
  return size > 0 ? std::min(size, 8192.0f) : 1.0f;
}

bool isNear(const WindowVertex &vertex) {
  return std::fabs(vertex.x) < kGuard && std::fabs(vertex.y) < kGuard;
}

/// Returns the height of the point's centre in the image.
float heightOf(const RasterState &state, const WindowVertex &at) {
  return state.upsideDownHeight != 0 ? float(state.upsideDownHeight) - at.y : at.y;
}

/// Clips the shape's rectangle. Returns false if nothing is left.
bool clipTo(const Rect &clip, Shape &shape) {
  shape.left = std::max(shape.left, clip.x);
  shape.bottom = std::max(shape.bottom, clip.y);
  shape.right = std::min(shape.right, clip.x + clip.width);
  shape.top = std::min(shape.top, clip.y + clip.height);
  return shape.left < shape.right && shape.bottom < shape.top;
}

/// Sets all of the shape but its bounds.
void fill(const Draw &draw, const Stroke &stroke, const StrokeEnd &at, Shape &shape) {
  shape.edgeCount = 0;
  shape.stippled = false;
  makePointPlanes(draw.plan, stroke.primitive(at), shape.primitive);
}

/// Returns the third component of sprite coordinates. It is a quotient of the vertex's coordinates,
/// so it does not matter whether these were divided by w.
float thirdOf(const RasterState &state, const abi::Plane *vertex) {
  using Third = RasterState::SpriteThird;
  if (state.spriteThird == Third::Zero)
    return 0.0f;
  return vertex[state.spriteThird == Third::S ? 0 : 2].c / vertex[3].c;
}

} // namespace

bool shapeOfPoint(const Draw &draw, const Stroke &stroke, const StrokeEnd &at, float size,
                  Shape &shape) {
  const RasterState &state = draw.state;
  if (!isNear(at.window))
    return false;
  size = sizeWithin(state, size);
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
  if (!clipTo(state.clip, shape))
    return false;
  fill(draw, stroke, at, shape);
  for (std::uint32_t i = 0; i < draw.shading.inputCount; ++i) {
    if (!((state.spriteInputs >> i) & 1u))
      continue;
    const bool divided = draw.shading.interpolation[i] != abi::Interpolation::Linear;
    const float scale = divided ? at.window.inverseW : 1.0f;
    // Sprite coordinates follow the host's window coordinates, whose y points down in windows.
    const float across = float(kSubpixels) / float(width);
    const float down = (height == 0) == state.spriteOriginLowerLeft ? across : -across;
    abi::Plane *const input = shape.primitive.inputs[i];
    const float third = thirdOf(state, input) * scale;
    const float left = 0.5f - across * (at.window.x - 0.5f);
    const float top = 0.5f - down * (at.window.y - 0.5f);
    input[0] = {left * scale, across * scale, 0};
    input[1] = {top * scale, 0, (height != 0 ? -down : down) * scale};
    input[2] = {third, 0, 0};
    input[3] = {scale, 0, 0};
  }
  return true;
}

bool shapeOfSmoothPoint(const Draw &draw, const Stroke &stroke, const StrokeEnd &at, float size,
                        Shape &shape) {
  if (!isNear(at.window))
    return false;
  // As the software host does it, so that frames of both look alike. A radius is at least 1 unless
  // vertices have point sizes. Between the circle and one that is a pixel smaller, the host's
  // formula gives 1 instead of fading.
  const float half = 0.5f * sizeWithin(draw.state, size);
  const float radius = draw.vertices.pointSize ? half : std::max(half, 1.0f);
  const float x = at.window.x, y = heightOf(draw.state, at.window);
  // A centre on the circle is inside on the left and lower side, as for a rectangle.
  WindowVertex corner[2] = {at.window, at.window};
  for (int i = 0; i < 2; ++i) {
    corner[i].x += i == 0 ? -radius : radius;
    corner[i].y += (i == 0) == (draw.state.upsideDownHeight == 0) ? -radius : radius;
    snapVertex(corner[i], draw.state.upsideDownHeight);
  }
  shape.left = pixelFrom(corner[0].fixedX);
  shape.bottom = pixelFrom(corner[0].fixedY);
  shape.right = pixelFrom(corner[1].fixedX);
  shape.top = pixelFrom(corner[1].fixedY);
  if (!clipTo(draw.state.clip, shape))
    return false;
  fill(draw, stroke, at, shape);
  const float step = 1.0f / radius;
  abi::Plane *const input = shape.primitive.inputs[draw.shading.inputCount - 1];
  input[0] = {(0.5f - x) * step, step, 0};
  input[1] = {(float(planesBegin(draw.state)) + 0.5f - y) * step, 0, step};
  // If the inner circle is not smaller than the outer one, the whole disc is covered.
  const float inner = (radius - 1) * step, ring = 1.0f - inner * inner;
  constexpr float kAll = 0x1p100f;
  input[2] = {ring > 0 ? 1.0f / ring : kAll, 0, 0};
  input[3] = {};
  return true;
}

} // namespace arbiter::swrast
