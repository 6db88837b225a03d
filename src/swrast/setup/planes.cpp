#include "swrast/setup/planes.h"

#include <algorithm>
#include <cmath>

#include "swrast/setup/shape.h"

namespace arbiter::swrast {

HostOrder::HostOrder(const RasterState &state, const Triangle &triangle) {
  // If no corner provokes, as in one half of a quad, the order stays as it is.
  int provoking = state.provokingIsFirst ? 0 : 2;
  if (triangle.cuts)
    provoking = 0;
  else
    for (int k = 0; k < 3; ++k)
      if (triangle.vertex[k] == triangle.provoking)
        provoking = k;
  const int first = state.provokingIsFirst ? provoking : (provoking + 1) % 3;
  for (int k = 0; k < 3; ++k)
    corner[k] = (first + k) % 3;
  // Hosts count rows of a window from the top, which reverses the winding.
  const std::int64_t area = areaOf(triangle.corner);
  if ((state.upsideDownHeight != 0 ? -area : area) > 0)
    std::swap(corner[1], corner[state.provokingIsFirst ? 2 : 0]);
}

namespace {

constexpr float kMissing[4] = {0, 0, 0, 1};

/// Computes depth, as exactly as possible, for a triangle that only has an area by its snapped
/// corners.
abi::Plane exactDepth(const RasterState &state, const WindowVertex *const (&corner)[3]) {
  constexpr double kUnit = 1.0 / kSubpixels;
  const double x1 = (corner[1]->fixedX - corner[0]->fixedX) * kUnit;
  const double y1 = (corner[1]->fixedY - corner[0]->fixedY) * kUnit;
  const double x2 = (corner[2]->fixedX - corner[0]->fixedX) * kUnit;
  const double y2 = (corner[2]->fixedY - corner[0]->fixedY) * kUnit;
  const double z1 = double(corner[1]->z) - corner[0]->z, z2 = double(corner[2]->z) - corner[0]->z;
  const double area = x1 * y2 - x2 * y1;
  const double inverse = area != 0 ? 1.0 / area : 0.0;
  const double dx = (z1 * y2 - z2 * y1) * inverse, dy = (z2 * x1 - z1 * x2) * inverse;
  const double toX = -corner[0]->fixedX * kUnit;
  const double toY = planesBegin(state) - corner[0]->fixedY * kUnit;
  return {float(corner[0]->z + dx * toX + dy * toY), float(dx), float(dy)};
}

/// Returns the polygon offset of a triangle without an area. `plane` holds its slopes.
float depthOffsetOf(const RasterState &state, const abi::Plane &plane) {
  const float slope = std::max(std::fabs(plane.dx), std::fabs(plane.dy));
  return float(state.depthResolution * state.offsetUnits) + slope * state.offsetFactor;
}

/// Reads one component of an input at a primitive's corners.
class Values {
public:
  Values(const PlanePlan::Source &source, const Triangle &primitive)
      : m_values(source.values[primitive.backFacing ? 1 : 0]),
        m_mask(source.mask[primitive.backFacing ? 1 : 0]), m_primitive(primitive) {
    if (!primitive.cuts)
      return;
    for (int k = 0; k < 3; ++k)
      m_places[k] = ofVertex(primitive.vertex[k]);
    primitive.cuts->follow(m_places);
  }
  [[nodiscard]] float at(int corner) const {
    return m_primitive.cuts ? m_places[m_primitive.place[corner]]
                            : ofVertex(m_primitive.vertex[corner]);
  }
  [[nodiscard]] float ofVertex(std::uint32_t vertex) const { return m_values[vertex & m_mask]; }

private:
  const float *m_values;
  std::uint32_t m_mask;
  const Triangle &m_primitive;
  float m_places[Cuts::kVertices + Cuts::kMax];
};

/// Computes all planes but that of depth. \param order the order of the corners in `steps`
template <int kCorners, typename Steps>
void makeAll(const PlanePlan &plan, const Triangle &own, const Steps &steps,
             const int (&order)[kCorners], abi::Primitive &primitive) {
  primitive.backFacing = own.backFacing ? 1 : 0;
  float inverseW[kCorners], f[kCorners];
  for (int k = 0; k < kCorners; ++k)
    inverseW[k] = own.corner[order[k]].inverseW;
  if (plan.wantsW)
    primitive.inverseW = steps.plane(inverseW);
  for (int i = 0; i < plan.count; ++i) {
    const PlanePlan::Source &source = plan.sources[i];
    const Values values(source, own);
    abi::Plane &plane = primitive.inputs[source.input][source.component];
    if (i >= plan.flatFrom) {
      plane = {values.ofVertex(own.provoking), 0, 0};
      continue;
    }
    for (int k = 0; k < kCorners; ++k)
      f[k] = i < plan.linearFrom ? values.at(order[k]) * inverseW[k] : values.at(order[k]);
    plane = steps.plane(f);
  }
}

} // namespace

float depthOffset(const RasterState &state, const std::array<WindowVertex, 3> &corner) {
  // In single precision and from the last corner, as hosts compute it. A corner that two polygons
  // share is drawn twice, and the last bit decides whether it passes the depth test again.
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
  add(abi::Interpolation::Even);
  linearFrom = count;
  add(abi::Interpolation::Linear);
  flatFrom = count;
  add(abi::Interpolation::Flat);
}

PlaneSteps::PlaneSteps(const RasterState &state, const WindowVertex *const (&corner)[3])
    : m_corner{corner[0], corner[1], corner[2]}, m_x01(corner[0]->x - corner[1]->x),
      m_y01(corner[0]->y - corner[1]->y), m_x20(corner[2]->x - corner[0]->x),
      m_y20(corner[2]->y - corner[0]->y), m_turns(state.upsideDownHeight != 0) {
  const float area = m_x01 * m_y20 - m_x20 * m_y01;
  m_inverse = 1.0f / area;
  m_isThin = area == 0 || !std::isfinite(area);
}

abi::Plane PlaneSteps::plane(const float (&f)[3]) const {
  const float f01 = f[0] - f[1], f20 = f[2] - f[0];
  const float dx = f01 * (m_y20 * m_inverse) - (m_y01 * m_inverse) * f20;
  const float dy = f20 * (m_x01 * m_inverse) - (m_x20 * m_inverse) * f01;
  const float c = f[0] - (dx * (m_corner[0]->x - 0.5f) + dy * (m_corner[0]->y - 0.5f));
  return {c, dx, m_turns ? -dy : dy};
}

LineSteps::LineSteps(const RasterState &state, const WindowVertex &from, const WindowVertex &to)
    : m_x(from.x - to.x), m_y(from.y - to.y), m_fromX(from.x), m_fromY(from.y),
      m_turns(state.upsideDownHeight != 0) {
  m_inverse = 1.0f / (m_x * m_x + m_y * m_y);
  // Values vary along the line's major direction alone.
  if (std::fabs(m_x) >= std::fabs(m_y)) {
    const float slope = m_y / m_x;
    m_x *= 1.0f + slope * slope;
    m_y = 0;
  } else {
    const float slope = m_x / m_y;
    m_y *= 1.0f + slope * slope;
    m_x = 0;
  }
}

abi::Plane LineSteps::plane(const float (&f)[2]) const {
  const float rise = f[0] - f[1];
  const float dx = rise * m_x * m_inverse, dy = rise * m_y * m_inverse;
  const float c = f[0] - (dx * (m_fromX - 0.5f) + dy * (m_fromY - 0.5f));
  return {c, dx, m_turns ? -dy : dy};
}

abi::DepthPlane makeDepthPlane(const RasterState &state, const PlaneSteps &steps, bool offset) {
  const float z[3] = {steps.m_corner[0]->z, steps.m_corner[1]->z, steps.m_corner[2]->z};
  const bool isLevel = z[0] == z[1] && z[0] == z[2];
  const abi::Plane plane = isLevel          ? abi::Plane{z[0], 0, 0}
                           : steps.m_isThin ? exactDepth(state, steps.m_corner)
                                            : steps.plane(z);
  float raised = 0;
  if (offset && (isLevel || steps.m_isThin)) {
    raised = depthOffsetOf(state, plane);
  } else if (offset) {
    const float z01 = z[0] - z[1], z20 = z[2] - z[0];
    const float slopeX = std::fabs((steps.m_y01 * z20 - z01 * steps.m_y20) * steps.m_inverse);
    const float slopeY = std::fabs((z01 * steps.m_x20 - steps.m_x01 * z20) * steps.m_inverse);
    raised = std::max(slopeX, slopeY) * state.offsetFactor +
             float(state.depthResolution * state.offsetUnits);
  }
  return {plane.c, plane.dx, plane.dy, raised};
}

void makePlanes(const PlanePlan &plan, const Triangle &triangle, const PlaneSteps &steps,
                const int (&order)[3], abi::Primitive &primitive) {
  makeAll(plan, triangle, steps, order, primitive);
}

void makePlanes(const RasterState &state, const PlanePlan &plan, const Triangle &triangle,
                bool offset, abi::Primitive &primitive) {
  const HostOrder order(state, triangle);
  const WindowVertex *const corner = triangle.corner;
  const PlaneSteps steps(
      state, {&corner[order.corner[0]], &corner[order.corner[1]], &corner[order.corner[2]]});
  if (plan.wantsDepth)
    primitive.z = makeDepthPlane(state, steps, offset);
  makeAll(plan, triangle, steps, order.corner, primitive);
}

void makeLinePlanes(const RasterState &state, const PlanePlan &plan, const Triangle &line,
                    abi::Primitive &primitive) {
  const LineSteps steps(state, line.corner[0], line.corner[1]);
  if (plan.wantsDepth) {
    const abi::Plane z = steps.plane({line.corner[0].z, line.corner[1].z});
    primitive.z = {z.c, z.dx, z.dy, 0};
  }
  constexpr int kOrder[2] = {0, 1};
  makeAll(plan, line, steps, kOrder, primitive);
}

namespace {
/// Points have constant values.
struct PointSteps {
  [[nodiscard]] static abi::Plane plane(const float (&f)[1]) { return {f[0], 0, 0}; }
};
} // namespace

void makePointPlanes(const PlanePlan &plan, const Triangle &point, abi::Primitive &primitive) {
  primitive.z = {point.corner[0].z, 0, 0, 0};
  constexpr int kOrder[1] = {0};
  makeAll(plan, point, PointSteps{}, kOrder, primitive);
}

} // namespace arbiter::swrast
