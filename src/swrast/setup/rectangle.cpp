#include "swrast/setup/rectangle.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "swrast/setup/assembly.h"
#include "swrast/setup/place.h"
#include "swrast/setup/planes.h"

namespace arbiter::swrast {
namespace {

bool samePlace(const Vertices &vertices, std::uint32_t a, std::uint32_t b) {
  for (const float *const component : vertices.position)
    if (component[a] != component[b])
      return false;
  return true;
}

/// Two triangles with a side in common: the corner that is the first's alone, a shared one, the
/// second's own, the other shared one.
bool joinTriangles(const Vertices &vertices, const std::uint32_t v[6], Rectangle &rectangle) {
  int own = -1, copies[3] = {-1, -1, -1};
  bool used[3] = {};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3 && copies[i] < 0; ++k) {
      if (!used[k] && (v[i] == v[3 + k] || samePlace(vertices, v[i], v[3 + k]))) {
        copies[i] = k;
        used[k] = true;
      }
    }
    if (copies[i] < 0) {
      if (own >= 0)
        return false;
      own = i;
    }
  }
  if (own < 0)
    return false;
  const int after = (own + 1) % 3, last = (own + 2) % 3;
  const int other = !used[0] ? 0 : !used[1] ? 1 : 2;
  // Wound the same way, the shared side runs against the first's direction in the second.
  if (copies[last] != (other + 1) % 3 || copies[after] != (other + 2) % 3)
    return false;
  rectangle.vertex[0] = v[own];
  rectangle.vertex[1] = v[after];
  rectangle.vertex[2] = v[3 + other];
  rectangle.vertex[3] = v[last];
  rectangle.others[0] = v[3 + copies[after]];
  rectangle.otherOf[0] = 1;
  rectangle.others[1] = v[3 + copies[last]];
  rectangle.otherOf[1] = 3;
  rectangle.otherCount = 2;
  return true;
}

bool cornersOf(Topology topology, const Vertices &vertices, const std::uint32_t *indices,
               std::uint32_t first, std::uint32_t count, Rectangle &rectangle) {
  if (count != (topology == Topology::Triangles ? 6u : 4u))
    return false;
  std::uint32_t v[6];
  for (std::uint32_t i = 0; i < count; ++i) {
    v[i] = indices ? indices[i] : first + i;
    if (v[i] >= vertices.count)
      return false;
  }
  switch (topology) {
  case Topology::Triangles:
    return joinTriangles(vertices, v, rectangle);
  case Topology::TriangleStrip:
  case Topology::QuadStrip:
    std::swap(v[2], v[3]);
    break;
  case Topology::TriangleFan:
  case Topology::Quads:
  case Topology::Polygon:
    break;
  default:
    return false;
  }
  std::copy(v, v + 4, rectangle.vertex);
  return true;
}

} // namespace

bool findRectangle(const RasterState &state, Topology topology, const Vertices &vertices,
                   const std::uint32_t *indices, std::uint32_t first, std::uint32_t count,
                   Rectangle &rectangle) {
  if (!cornersOf(topology, vertices, indices, first, count, rectangle))
    return false;
  const Viewport viewport = makeViewport(state, vertices);
  WindowVertex *const corner = rectangle.corner;
  placeCorners(viewport, vertices, rectangle.vertex, corner);
  for (int i = 0; i < 4; ++i) {
    // Cutting at the sides of the view volume leaves a rectangle of the same inputs.
    if (corner[i].outcode & ~kOutSides)
      return false;
    if (std::fabs(corner[i].x) > kGuard || std::fabs(corner[i].y) > kGuard)
      return false;
    if (corner[i].inverseW != corner[0].inverseW)
      return false;
  }
  const auto level = [&](int a, int b) { return corner[a].fixedY == corner[b].fixedY; };
  const auto upright = [&](int a, int b) { return corner[a].fixedX == corner[b].fixedX; };
  if (!(level(0, 1) && upright(1, 2) && level(2, 3) && upright(3, 0)) &&
      !(upright(0, 1) && level(1, 2) && upright(2, 3) && level(3, 0)))
    return false;
  const std::int64_t area = areaOf(corner);
  if (area == 0)
    return false;
  rectangle.backFacing = (area > 0) == state.frontIsClockwise;
  if (rectangle.backFacing ? state.cullBack : state.cullFront)
    return false;
  if ((rectangle.backFacing ? state.back : state.front) != PolygonMode::Fill)
    return false;
  const int left = pixelFrom(std::min(corner[0].fixedX, corner[2].fixedX));
  const int right = pixelFrom(std::max(corner[0].fixedX, corner[2].fixedX));
  const int bottom = pixelFrom(std::min(corner[0].fixedY, corner[2].fixedY));
  const int top = pixelFrom(std::max(corner[0].fixedY, corner[2].fixedY));
  rectangle.left = left;
  rectangle.bottom = bottom;
  rectangle.pixels =
      intersect(intersect({left, bottom, right - left, top - bottom}, state.clip), viewport.pixels);
  return true;
}

namespace {

/// Values that differ by rounding only: two triangles and one rectangle look the same.
bool fits(double a, double b, double scale) { return std::fabs(a - b) <= scale * 0x1p-22; }

bool isAffineOver(const Rectangle &rectangle, const float *values) {
  const float v0 = values[rectangle.vertex[0]], v1 = values[rectangle.vertex[1]];
  const float v2 = values[rectangle.vertex[2]], v3 = values[rectangle.vertex[3]];
  // One value for all, as the current colour is.
  const bool constant = v0 == v1 && v0 == v2 && v0 == v3 && std::fabs(v0) <= FLT_MAX;
  if (!constant) {
    const double f0 = v0, f1 = v1, f2 = v2, f3 = v3;
    const double scale = std::max({std::fabs(f0), std::fabs(f1), std::fabs(f2), std::fabs(f3)});
    if (!fits(f0 + f2, f1 + f3, scale))
      return false;
  }
  for (int i = 0; i < rectangle.otherCount; ++i)
    if (values[rectangle.others[i]] != values[rectangle.vertex[rectangle.otherOf[i]]])
      return false;
  return true;
}

} // namespace

bool shapeOfRectangle(const RasterState &state, const Shading &shading, Topology topology,
                      const Vertices &vertices, const Rectangle &rectangle, Shape &shape) {
  const WindowVertex *const corner = rectangle.corner;
  // Of depths that vary each of the two triangles has a plane of its own, to the last bit.
  const auto sameDepth = [&](const WindowVertex &other) { return other.z == corner[0].z; };
  if (shading.readsDepth && !std::all_of(corner + 1, corner + 4, sameDepth))
    return false;
  const bool onePolygon = topology == Topology::Quads || topology == Topology::QuadStrip ||
                          topology == Topology::Polygon;
  for (std::uint32_t i = 0; i < shading.inputCount; ++i) {
    const float *const *from = vertices.inputs[i];
    const float *const *const back = vertices.backInputs[i];
    if (rectangle.backFacing && (back[0] || back[1] || back[2] || back[3]))
      from = back;
    const bool flat = shading.interpolation[i] == abi::Interpolation::Flat;
    for (int c = 0; c < 4; ++c) {
      if (!((shading.inputComponents[i] >> c) & 1u) || !from[c])
        continue;
      if (flat && onePolygon)
        continue;
      if (!isAffineOver(rectangle, from[c]))
        return false;
      if (flat)
        for (const std::uint32_t vertex : rectangle.vertex)
          if (from[c][vertex] != from[c][rectangle.vertex[0]])
            return false;
    }
  }
  Triangle triangle;
  constexpr int kCorners[3] = {0, 1, 3};
  for (int k = 0; k < 3; ++k) {
    triangle.corner[k] = corner[kCorners[k]];
    triangle.vertex[k] = rectangle.vertex[kCorners[k]];
  }
  // A quad strip's last vertex is the third corner of the ring.
  const int last = topology == Topology::QuadStrip ? 2 : 3;
  const bool isFirst = provokesFirst(state, topology) || topology == Topology::Polygon;
  triangle.provoking = rectangle.vertex[isFirst ? 0 : last];
  triangle.backFacing = rectangle.backFacing;
  shape.left = rectangle.pixels.x;
  shape.bottom = rectangle.pixels.y;
  shape.right = rectangle.pixels.x + rectangle.pixels.width;
  shape.top = rectangle.pixels.y + rectangle.pixels.height;
  shape.setOrigin(rectangle.left, rectangle.bottom);
  shape.edgeCount = 0;
  shape.stippled = state.polygonStipple != nullptr;
  makePlanes(state, PlanePlan(shading, vertices), triangle, state.offsetFill, shape.originX,
             shape.originY, shape.primitive);
  return true;
}

Rect surelyCovered(const RasterState &state, Topology topology, const Vertices &vertices,
                   const std::uint32_t *indices, std::uint32_t first, std::uint32_t count) {
  Rectangle rectangle;
  if (state.polygonStipple ||
      !findRectangle(state, topology, vertices, indices, first, count, rectangle))
    return {};
  return rectangle.pixels;
}

bool isAffine(const Vertices &vertices) {
  const float *const w = vertices.position[3];
  for (std::uint32_t i = 1; i < vertices.count; ++i)
    if (w[i] != w[0])
      return false;
  return true;
}

} // namespace arbiter::swrast
