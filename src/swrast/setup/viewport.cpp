#include "swrast/setup/viewport.h"

#include <algorithm>
#include <cmath>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace arbiter::swrast {

namespace {

/// Returns std::lrintf() of the value in the default rounding mode.
std::int32_t roundToEven(float value) {
#if defined(__SSE__)
  return _mm_cvtss_si32(_mm_set_ss(value));
#else
  return std::int32_t(std::lrintf(value));
#endif
}

} // namespace

Viewport makeViewport(const RasterState &state, const Vertices &vertices) {
  Viewport result{};
  for (int i = 0; i < 2; ++i) {
    result.scale[i] = state.viewport[2 + i] * 0.5f;
    result.translate[i] = state.viewport[i] + result.scale[i];
  }
  result.upsideDownHeight = state.upsideDownHeight;
  if (result.upsideDownHeight != 0) {
    result.scale[1] = -result.scale[1];
    result.translate[1] = float(result.upsideDownHeight) - result.translate[1];
  }
  result.scale[2] = (state.depthFar - state.depthNear) * 0.5f;
  result.translate[2] = (state.depthFar + state.depthNear) * 0.5f;
  result.depthClamp = state.depthClamp;
  // std::ceil and std::lrintf would be function calls without the newer instruction sets, and this
  // code is a good part of a small draw.
  const auto place = [](double at) {
    const double value = std::clamp(at, -1e6, 1e6) - 0.5;
    const auto whole = std::int32_t(value);
    return whole + (double(whole) < value ? 1 : 0);
  };
  const int left = place(state.viewport[0]), bottom = place(state.viewport[1]);
  result.pixels = {left, bottom, place(double(state.viewport[0]) + state.viewport[2]) - left,
                   place(double(state.viewport[1]) + state.viewport[3]) - bottom};
  for (unsigned i = 0; i < 8; ++i)
    if (vertices.clipDistance[i])
      result.userPlanes |= 1u << i;
  return result;
}

void snapVertex(WindowVertex &vertex, int upsideDownHeight) {
  const auto snap = [](float value) {
    const float fixed = (value - 0.5f) * float(kSubpixels);
    return std::fabs(fixed) < 1e9f ? roundToEven(fixed) : 0;
  };
  vertex.fixedX = snap(vertex.x);
  vertex.fixedY = snap(vertex.y);
  if (upsideDownHeight != 0)
    vertex.fixedY = (upsideDownHeight - 1) * kSubpixels - vertex.fixedY;
}

void toWindow(const Viewport &viewport, const float clip[4], WindowVertex &vertex) {
  const float inverseW = 1.0f / clip[3];
  // Scale and translation are rounded once, like a fused multiply-add. Hosts do the same, and the
  // snapped position must not differ from theirs.
  const auto place = [&](int i) {
    return float(double(clip[i] * inverseW) * double(viewport.scale[i]) +
                 double(viewport.translate[i]));
  };
  vertex.x = place(0);
  vertex.y = place(1);
  vertex.z = place(2);
  vertex.inverseW = inverseW;
  snapVertex(vertex, viewport.upsideDownHeight);
}

void cutToWindow(const Viewport &viewport, const float clip[4], WindowVertex &vertex) {
  const float inverseW = 1.0f / clip[3];
  const auto place = [&](int i) {
    return clip[i] * inverseW * viewport.scale[i] + viewport.translate[i];
  };
  vertex.x = place(0);
  vertex.y = place(1);
  vertex.z = place(2);
  vertex.inverseW = inverseW;
  snapVertex(vertex, viewport.upsideDownHeight);
}

WindowVertex windowVertex(const Viewport &viewport, const Vertices &vertices, std::uint32_t index) {
  const float clip[4] = {vertices.position[0][index], vertices.position[1][index],
                         vertices.position[2][index], vertices.position[3][index]};
  const float w = clip[3];
  WindowVertex vertex{};
  std::uint32_t out = 0;
  out |= clip[0] < -w ? kOutLeft : 0u;
  out |= clip[0] > w ? kOutRight : 0u;
  out |= clip[1] < -w ? kOutBottom : 0u;
  out |= clip[1] > w ? kOutTop : 0u;
  if (!viewport.depthClamp) {
    out |= clip[2] < -w ? kOutNear : 0u;
    out |= clip[2] > w ? kOutFar : 0u;
  }
  out |= w > 0 ? 0u : kOutW;
  const float sum = clip[0] + clip[1] + clip[2] + clip[3];
  out |= sum - sum == 0 ? 0u : kOutNan; // infinity or NaN
  for (unsigned planes = viewport.userPlanes; planes != 0; planes &= planes - 1) {
    const auto plane = unsigned(__builtin_ctz(planes));
    out |= vertices.clipDistance[plane][index] >= 0 ? 0u : kOutUser << plane;
  }
  if (!(out & (kOutW | kOutNan)))
    toWindow(viewport, clip, vertex);
  vertex.outcode = out;
  return vertex;
}

} // namespace arbiter::swrast
