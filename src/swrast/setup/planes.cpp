#include "swrast/setup/planes.h"

#include <algorithm>
#include <cmath>

namespace arbiter::swrast {

Gradients gradientsOf(const RasterState &state, const WindowVertex corner[3], int originX,
                      int originY) {
  double x1 = double(corner[1].x) - corner[0].x, y1 = double(corner[1].y) - corner[0].y;
  double x2 = double(corner[2].x) - corner[0].x, y2 = double(corner[2].y) - corner[0].y;
  double toX = originX + 0.5 - corner[0].x, toY = originY + 0.5 - corner[0].y;
  if (state.upsideDownHeight != 0) {
    y1 = -y1;
    y2 = -y2;
    toY = originY + 0.5 - (double(state.upsideDownHeight) - corner[0].y);
  }
  double area = x1 * y2 - x2 * y1;
  constexpr double kUnit = 1.0 / kSubpixels;
  if (std::fabs(area) < kThinArea) {
    // The snapped corners have an area.
    x1 = (corner[1].fixedX - corner[0].fixedX) * kUnit;
    y1 = (corner[1].fixedY - corner[0].fixedY) * kUnit;
    x2 = (corner[2].fixedX - corner[0].fixedX) * kUnit;
    y2 = (corner[2].fixedY - corner[0].fixedY) * kUnit;
    toX = originX - corner[0].fixedX * kUnit;
    toY = originY - corner[0].fixedY * kUnit;
    area = x1 * y2 - x2 * y1;
  }
  const double inverse = area != 0 ? 1.0 / area : 0.0;
  return {y2 * inverse, -y1 * inverse, -x2 * inverse, x1 * inverse, toX, toY};
}

namespace {

constexpr float kMissing[4] = {0, 0, 0, 1};

/// A value at each corner.
template <bool kClipped>
void fetch(const PlanePlan::Source &source, const Triangle &triangle, double f[3]) {
  const int face = triangle.backFacing ? 1 : 0;
  const float *const values = source.values[face];
  const std::uint32_t mask = source.mask[face];
  double v[3];
  for (int k = 0; k < 3; ++k)
    v[k] = values[triangle.vertex[k] & mask];
  for (int k = 0; k < 3; ++k)
    f[k] = kClipped ? triangle.weight[k][0] * v[0] + triangle.weight[k][1] * v[1] +
                          triangle.weight[k][2] * v[2]
                    : v[k];
}

template <bool kClipped>
void makeInputs(const PlanePlan &plan, const Triangle &triangle, const Gradients &g,
                abi::Primitive &primitive) {
  double inverseW[3], f[3];
  for (int k = 0; k < 3; ++k)
    inverseW[k] = triangle.corner[k].inverseW;
  for (int i = 0; i < plan.linearFrom; ++i) {
    const PlanePlan::Source &source = plan.sources[i];
    fetch<kClipped>(source, triangle, f);
    primitive.inputs[source.input][source.component] =
        g.plane(f[0] * inverseW[0], f[1] * inverseW[1], f[2] * inverseW[2]);
  }
  for (int i = plan.linearFrom; i < plan.flatFrom; ++i) {
    const PlanePlan::Source &source = plan.sources[i];
    fetch<kClipped>(source, triangle, f);
    primitive.inputs[source.input][source.component] = g.plane(f[0], f[1], f[2]);
  }
}

/// The corners in the order of hosts: the provoking one is the first or the last, and of a piece of
/// what was cut that is the centre of the fan. Of a triangle that is clockwise to them two change
/// places, the provoking one stays.
void asHostsWalk(const Triangle &triangle, bool provokingIsFirst, bool clockwise,
                 const WindowVertex *v[3]) {
  int provoking = provokingIsFirst ? 0 : 2; // of a quad's half without it the order is as it is
  if (triangle.weight)
    provoking = 0;
  else
    for (int k = 0; k < 3; ++k)
      if (triangle.vertex[k] == triangle.provoking)
        provoking = k;
  const int first = provokingIsFirst ? provoking : (provoking + 1) % 3;
  for (int k = 0; k < 3; ++k)
    v[k] = &triangle.corner[(first + k) % 3];
  if (clockwise)
    std::swap(v[1], v[provokingIsFirst ? 2 : 0]);
}

/// Of a triangle without an area, whose slopes are those of `plane`.
float depthOffsetOf(const RasterState &state, const abi::DepthPlane &plane) {
  const float slope = std::max(std::fabs(plane.dx), std::fabs(plane.dy));
  return float(state.depthResolution * state.offsetUnits) + slope * state.offsetFactor;
}

} // namespace

float depthOffset(const RasterState &state, const std::array<WindowVertex, 3> &corner) {
  // In single precision and from the last corner, as hosts have it: a corner that two polygons
  // share is drawn twice, and whether it passes the depth test again depends on the last bit.
  const WindowVertex &last = corner[2];
  const float ex = corner[0].x - last.x, ey = corner[0].y - last.y, ez = corner[0].z - last.z;
  const float fx = corner[1].x - last.x, fy = corner[1].y - last.y, fz = corner[1].z - last.z;
  const float inverse = 1.0f / (ex * fy - ey * fx);
  const float dx = std::fabs((ey * fz - ez * fy) * inverse);
  const float dy = std::fabs((ez * fx - ex * fz) * inverse);
  return float(state.depthResolution * state.offsetUnits) + std::max(dx, dy) * state.offsetFactor;
}

PlanePlan::PlanePlan(const Shading &shading, const Vertices &vertices)
    : wantsDepth(shading.readsDepth), wantsW(shading.readsW) {
  const auto add = [&](abi::Interpolation interpolation) {
    for (std::uint32_t i = 0; i < shading.inputCount; ++i) {
      if (shading.interpolation[i] != interpolation)
        continue;
      const float *const *const front = vertices.inputs[i];
      const float *const *back = vertices.backInputs[i];
      if (!back[0] && !back[1] && !back[2] && !back[3])
        back = front;
      for (int c = 0; c < 4; ++c) {
        if (!((shading.inputComponents[i] >> c) & 1u))
          continue;
        sources[count++] = {{front[c] ? front[c] : &kMissing[c], back[c] ? back[c] : &kMissing[c]},
                            {front[c] ? ~0u : 0u, back[c] ? ~0u : 0u},
                            std::uint8_t(i),
                            std::uint8_t(c)};
      }
    }
  };
  add(abi::Interpolation::Perspective);
  linearFrom = count;
  add(abi::Interpolation::Linear);
  flatFrom = count;
  add(abi::Interpolation::Flat);
}

abi::DepthPlane makeDepthPlane(const RasterState &state, const Triangle &triangle, bool offset) {
  const WindowVertex *const corner = triangle.corner;
  const float x1 = corner[1].x - corner[0].x, y1 = corner[1].y - corner[0].y;
  const float x2 = corner[2].x - corner[0].x, y2 = corner[2].y - corner[0].y;
  const WindowVertex *v[3];
  asHostsWalk(triangle, state.provokingIsFirst, x1 * y2 - x2 * y1 > 0, v);
  if (v[0]->z == v[1]->z && v[0]->z == v[2]->z) {
    const abi::DepthPlane level = {v[0]->z, 0, 0};
    return {level.c, 0, 0, offset ? depthOffsetOf(state, level) : 0.0f};
  }
  const float x01 = v[0]->x - v[1]->x, y01 = v[0]->y - v[1]->y, z01 = v[0]->z - v[1]->z;
  const float x20 = v[2]->x - v[0]->x, y20 = v[2]->y - v[0]->y, z20 = v[2]->z - v[0]->z;
  const float area = x01 * y20 - x20 * y01;
  if (area == 0 || !std::isfinite(area)) {
    abi::DepthPlane exact = depthPlaneOf(state, corner);
    if (offset)
      exact.offset = depthOffsetOf(state, exact);
    return exact;
  }
  const float inverse = 1.0f / area;
  const float dx = z01 * (y20 * inverse) - (y01 * inverse) * z20;
  const float dy = z20 * (x01 * inverse) - (x20 * inverse) * z01;
  const float c = v[0]->z - (dx * (v[0]->x - 0.5f) + dy * (v[0]->y - 0.5f));
  float raised = 0;
  if (offset) {
    const float slopeX = std::fabs((y01 * z20 - z01 * y20) * inverse);
    const float slopeY = std::fabs((z01 * x20 - x01 * z20) * inverse);
    raised = std::max(slopeX, slopeY) * state.offsetFactor +
             float(state.depthResolution * state.offsetUnits);
  }
  return {c, dx, state.upsideDownHeight != 0 ? -dy : dy, raised, depthOriginY(state)};
}

abi::DepthPlane makeLineDepthPlane(const RasterState &state, const WindowVertex &from,
                                   const WindowVertex &to) {
  float alongX = from.x - to.x, alongY = from.y - to.y;
  const float inverse = 1.0f / (alongX * alongX + alongY * alongY);
  // As if depth varied along the greater direction alone.
  if (std::fabs(alongX) >= std::fabs(alongY)) {
    const float slope = alongY / alongX;
    alongX *= 1.0f + slope * slope;
    alongY = 0;
  } else {
    const float slope = alongX / alongY;
    alongY *= 1.0f + slope * slope;
    alongX = 0;
  }
  const float rise = from.z - to.z;
  const float dx = rise * alongX * inverse, dy = rise * alongY * inverse;
  const float c = from.z - (dx * (from.x - 0.5f) + dy * (from.y - 0.5f));
  return {c, dx, state.upsideDownHeight != 0 ? -dy : dy, 0, depthOriginY(state)};
}

abi::DepthPlane depthPlaneOf(const RasterState &state, const WindowVertex corner[3]) {
  const int originY = depthOriginY(state);
  const abi::Plane plane =
      gradientsOf(state, corner, 0, originY).plane(corner[0].z, corner[1].z, corner[2].z);
  return {plane.c, plane.dx, plane.dy, 0, originY};
}

void makePlanes(const PlanePlan &plan, const Triangle &triangle, const Gradients &g, int originX,
                int originY, abi::Primitive &primitive) {
  primitive.originX = originX;
  primitive.originY = originY;
  primitive.backFacing = triangle.backFacing ? 1 : 0;
  const WindowVertex *const v = triangle.corner;
  if (plan.wantsW)
    primitive.inverseW = g.plane(v[0].inverseW, v[1].inverseW, v[2].inverseW);
  if (triangle.weight)
    makeInputs<true>(plan, triangle, g, primitive);
  else
    makeInputs<false>(plan, triangle, g, primitive);
  const int face = triangle.backFacing ? 1 : 0;
  for (int i = plan.flatFrom; i < plan.count; ++i) {
    const PlanePlan::Source &source = plan.sources[i];
    primitive.inputs[source.input][source.component] = {
        source.values[face][triangle.provoking & source.mask[face]], 0, 0};
  }
}

void makePointPlanes(const PlanePlan &plan, const Triangle &point, int originX, int originY,
                     abi::Primitive &primitive) {
  const WindowVertex &at = point.corner[0];
  primitive.originX = originX;
  primitive.originY = originY;
  primitive.backFacing = point.backFacing ? 1 : 0;
  primitive.z = {at.z, 0, 0};
  if (plan.wantsW)
    primitive.inverseW = {at.inverseW, 0, 0};
  const int face = point.backFacing ? 1 : 0;
  const double *const weight = point.weight[0];
  const bool isVertex = point.vertex[0] == point.vertex[1] && point.vertex[0] == point.vertex[2] &&
                        weight[0] == 1 && weight[1] == 0 && weight[2] == 0;
  for (int i = 0; i < plan.count; ++i) {
    const PlanePlan::Source &source = plan.sources[i];
    const float *const values = source.values[face];
    const std::uint32_t mask = source.mask[face];
    double value = double(values[point.vertex[0] & mask]);
    if (isVertex) {
      value += value - value; // what the sum below comes to: no number of an infinite one
    } else {
      value = 0;
      for (int k = 0; k < 3; ++k)
        value += weight[k] * double(values[point.vertex[k] & mask]);
    }
    if (i < plan.linearFrom)
      value *= double(at.inverseW);
    else if (i >= plan.flatFrom)
      value = values[point.provoking & mask];
    primitive.inputs[source.input][source.component] = {float(value), 0, 0};
  }
}

void makePlanes(const RasterState &state, const PlanePlan &plan, const Triangle &triangle,
                bool offset, int originX, int originY, abi::Primitive &primitive) {
  if (plan.wantsDepth)
    primitive.z = makeDepthPlane(state, triangle, offset);
  const Gradients g = gradientsOf(state, triangle.corner, originX, originY);
  makePlanes(plan, triangle, g, originX, originY, primitive);
}

} // namespace arbiter::swrast
