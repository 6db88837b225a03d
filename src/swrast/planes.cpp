#include <algorithm>
#include <cmath>

#include "swrast/setup.h"

/// Triangles to edges and planes.
namespace arbiter::swrast {

std::int64_t areaOf(const WindowVertex corner[3]) {
  const std::int64_t ax = corner[1].fixedX - corner[0].fixedX;
  const std::int64_t ay = corner[1].fixedY - corner[0].fixedY;
  const std::int64_t bx = corner[2].fixedX - corner[0].fixedX;
  const std::int64_t by = corner[2].fixedY - corner[0].fixedY;
  return ax * by - bx * ay;
}

Edge edgeBetween(const WindowVertex &from, const WindowVertex &to) {
  Edge edge;
  edge.a = from.fixedY - to.fixedY;
  edge.b = to.fixedX - from.fixedX;
  std::int64_t c = -(std::int64_t(edge.a) * from.fixedX + std::int64_t(edge.b) * from.fixedY);
  // A centre on a left or a lower edge is inside, on another it is the neighbour's.
  if (!(edge.a > 0 || (edge.a == 0 && edge.b > 0)))
    --c;
  // Pixels are 256 units apart, so that what is below such a step never decides.
  edge.c = c >> kSubpixelBits;
  return edge;
}

bool setBounds(const Rect &clip, const WindowVertex *corner, int count, Shape &shape) {
  std::int32_t minX = corner[0].fixedX, maxX = minX, minY = corner[0].fixedY, maxY = minY;
  for (int i = 1; i < count; ++i) {
    minX = std::min(minX, corner[i].fixedX);
    maxX = std::max(maxX, corner[i].fixedX);
    minY = std::min(minY, corner[i].fixedY);
    maxY = std::max(maxY, corner[i].fixedY);
  }
  shape.left = std::max(clip.x, pixelFrom(minX));
  shape.bottom = std::max(clip.y, pixelFrom(minY));
  // A right or an upper edge is outside itself, but not a corner that a left edge ends in.
  shape.right = std::min(clip.x + clip.width, (maxX >> kSubpixelBits) + 1);
  shape.top = std::min(clip.y + clip.height, (maxY >> kSubpixelBits) + 1);
  return shape.left < shape.right && shape.bottom < shape.top;
}

bool shapeOf(const Rect &clip, const WindowVertex corner[3], std::int64_t area, Shape &shape) {
  if (!setBounds(clip, corner, 3, shape))
    return false;
  const int second = area > 0 ? 1 : 2, third = 3 - second;
  shape.edgeCount = 3;
  shape.edges[0] = edgeBetween(corner[0], corner[second]);
  shape.edges[1] = edgeBetween(corner[second], corner[third]);
  shape.edges[2] = edgeBetween(corner[third], corner[0]);
  return true;
}

namespace {

/// The linear functions over a triangle.
struct Gradients {
  double x1, y1, x2, y2; ///< corners 1 and 2 from corner 0
  double inverse;
  double toX, toY; ///< the origin's centre from corner 0

  [[nodiscard]] abi::Plane plane(double f0, double f1, double f2) const {
    const double d1 = f1 - f0, d2 = f2 - f0;
    const double dx = (d1 * y2 - d2 * y1) * inverse, dy = (d2 * x1 - d1 * x2) * inverse;
    return {float(f0 + dx * toX + dy * toY), float(dx), float(dy)};
  }
};

Gradients gradientsOf(const RasterState &state, const WindowVertex corner[3], int originX,
                      int originY) {
  Gradients g{};
  g.x1 = double(corner[1].x) - corner[0].x;
  g.y1 = double(corner[1].y) - corner[0].y;
  g.x2 = double(corner[2].x) - corner[0].x;
  g.y2 = double(corner[2].y) - corner[0].y;
  g.toX = originX + 0.5 - corner[0].x;
  g.toY = originY + 0.5 - corner[0].y;
  if (state.upsideDownHeight != 0) {
    g.y1 = -g.y1;
    g.y2 = -g.y2;
    g.toY = originY + 0.5 - (double(state.upsideDownHeight) - corner[0].y);
  }
  double area = g.x1 * g.y2 - g.x2 * g.y1;
  constexpr double kUnit = 1.0 / kSubpixels;
  if (std::fabs(area) < kUnit * kUnit) {
    // So thin that what was lost by snapping could turn it over: the snapped corners have an area.
    g.x1 = (corner[1].fixedX - corner[0].fixedX) * kUnit;
    g.y1 = (corner[1].fixedY - corner[0].fixedY) * kUnit;
    g.x2 = (corner[2].fixedX - corner[0].fixedX) * kUnit;
    g.y2 = (corner[2].fixedY - corner[0].fixedY) * kUnit;
    g.toX = originX - corner[0].fixedX * kUnit;
    g.toY = originY - corner[0].fixedY * kUnit;
    area = g.x1 * g.y2 - g.x2 * g.y1;
  }
  g.inverse = area != 0 ? 1.0 / area : 0.0;
  return g;
}

float offsetOf(const RasterState &state, const abi::Plane &z) {
  const float slope = std::max(std::fabs(z.dx), std::fabs(z.dy));
  return float(double(slope) * state.offsetFactor + state.depthResolution * state.offsetUnits);
}

constexpr float kMissing[4] = {0, 0, 0, 1};

} // namespace

float depthOffset(const RasterState &state, const WindowVertex corner[3]) {
  return offsetOf(state,
                  gradientsOf(state, corner, 0, 0).plane(corner[0].z, corner[1].z, corner[2].z));
}

void makePlanes(const RasterState &state, const Shading &shading, const Vertices &vertices,
                const Triangle &triangle, bool offset, int originX, int originY,
                abi::Primitive &primitive) {
  primitive.originX = originX;
  primitive.originY = originY;
  primitive.backFacing = triangle.backFacing ? 1 : 0;
  const WindowVertex *const v = triangle.corner;
  const Gradients g = gradientsOf(state, v, originX, originY);
  if (shading.readsDepth || offset) {
    primitive.z = g.plane(v[0].z, v[1].z, v[2].z);
    if (offset)
      primitive.z.c += offsetOf(state, primitive.z);
  }
  if (shading.readsW)
    primitive.inverseW = g.plane(v[0].inverseW, v[1].inverseW, v[2].inverseW);
  for (std::uint32_t i = 0; i < shading.inputCount; ++i) {
    const float *const *from = vertices.inputs[i];
    const float *const *const back = vertices.backInputs[i];
    if (triangle.backFacing && (back[0] || back[1] || back[2] || back[3]))
      from = back;
    for (int c = 0; c < 4; ++c) {
      if (!((shading.inputComponents[i] >> c) & 1u))
        continue;
      abi::Plane &plane = primitive.inputs[i][c];
      const float *const values = from[c];
      if (shading.interpolation[i] == abi::Interpolation::Flat) {
        plane = {values ? values[triangle.provoking] : kMissing[c], 0, 0};
        continue;
      }
      double f[3];
      for (int k = 0; k < 3; ++k)
        f[k] = values ? values[triangle.vertex[k]] : kMissing[c];
      if (triangle.clipped && values) {
        double at[3];
        for (int k = 0; k < 3; ++k)
          at[k] = triangle.weight[k][0] * f[0] + triangle.weight[k][1] * f[1] +
                  triangle.weight[k][2] * f[2];
        std::copy(at, at + 3, f);
      }
      if (shading.interpolation[i] == abi::Interpolation::Perspective)
        for (int k = 0; k < 3; ++k)
          f[k] *= double(v[k].inverseW);
      plane = g.plane(f[0], f[1], f[2]);
    }
  }
}

} // namespace arbiter::swrast
