#include "swrast/setup/rectangle.h"

#include <algorithm>
#include <cmath>

#include "swrast/setup/assembly.h"
#include "swrast/setup/place.h"

namespace arbiter::swrast {
namespace {

bool samePlace(const Vertices &vertices, std::uint32_t a, std::uint32_t b) {
  for (const float *const component : vertices.position)
    if (component[a] != component[b])
      return false;
  return true;
}

/// Joins two triangles that share a side into four corners: the first triangle's own corner, a
/// shared one, the second triangle's own corner, the other shared one. Returns false if they share
/// none.
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
  // Triangles with the same winding traverse the shared side in opposite directions.
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
    // Clipping at the sides of the view volume leaves a rectangle with the same inputs.
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
  rectangle.pixels =
      intersect(intersect({left, bottom, right - left, top - bottom}, state.clip), viewport.pixels);
  return true;
}

namespace {

/// True if all planes in the plan are equal to the last bit.
bool isAlike(const PlanePlan &plan, const abi::Primitive &a, const abi::Primitive &b) {
  const auto same = [](const auto &one, const auto &other) {
    return one.c == other.c && one.dx == other.dx && one.dy == other.dy;
  };
  if (plan.wantsDepth && !(same(a.z, b.z) && a.z.offset == b.z.offset))
    return false;
  if (plan.wantsW && !same(a.inverseW, b.inverseW))
    return false;
  return std::all_of(plan.sources, plan.sources + plan.count, [&](const auto &source) {
    return same(a.inputs[source.input][source.component], b.inputs[source.input][source.component]);
  });
}

/// True if all planes in the plan are constant.
bool isLevel(const PlanePlan &plan, const abi::Primitive &primitive) {
  const auto level = [](const auto &plane) { return plane.dx == 0 && plane.dy == 0; };
  if ((plan.wantsDepth && !level(primitive.z)) || (plan.wantsW && !level(primitive.inverseW)))
    return false;
  return std::all_of(plan.sources, plan.sources + plan.count, [&](const auto &source) {
    return level(primitive.inputs[source.input][source.component]);
  });
}

} // namespace

int shapesOfRectangle(const Draw &draw, const Rectangle &rectangle, Shape (&shapes)[2]) {
  const RasterState &state = draw.state;
  bool isCut = false;
  for (const WindowVertex &corner : rectangle.corner)
    isCut = isCut || corner.outcode != 0;
  int halves = 0;
  for (std::uint32_t i = 0; i < 2; ++i) {
    const TriangleCorners corners =
        triangleAt(draw.topology, draw.count, i, provokesFirst(state, draw.topology),
                   cutsOtherwise(state, draw.topology, isCut));
    Triangle triangle;
    for (int k = 0; k < 3; ++k) {
      triangle.vertex[k] = draw.vertexAt(corners.corner[k]);
      triangle.corner[k] = rectangle.cornerOf(triangle.vertex[k]);
    }
    triangle.provoking = draw.vertexAt(corners.provoking);
    triangle.backFacing = rectangle.backFacing;
    Shape &half = shapes[halves];
    if (!isCut && !shapeOf(rectangle.pixels, triangle.corner, areaOf(triangle.corner), half))
      continue; // the scissor removes this half
    makePlanes(state, draw.plan, triangle, state.offsetFill, half.primitive);
    half.stippled = state.polygonStipple != nullptr;
    ++halves;
  }
  Shape &whole = shapes[0];
  if (halves == 2 && !isAlike(draw.plan, whole.primitive, shapes[1].primitive))
    return isCut ? 0 : 2;
  if (isCut && !isLevel(draw.plan, whole.primitive))
    return 0;
  whole.left = rectangle.pixels.x;
  whole.bottom = rectangle.pixels.y;
  whole.right = rectangle.pixels.x + rectangle.pixels.width;
  whole.top = rectangle.pixels.y + rectangle.pixels.height;
  whole.edgeCount = 0;
  return 1;
}

Rect surelyCovered(const RasterState &state, Topology topology, const Vertices &vertices,
                   const std::uint32_t *indices, std::uint32_t first, std::uint32_t count) {
  Rectangle rectangle;
  if (state.polygonStipple ||
      !findRectangle(state, topology, vertices, indices, first, count, rectangle))
    return {};
  return rectangle.pixels;
}

abi::Interpolation interpolationOf(const Vertices &vertices) {
  const float *const w = vertices.position[3];
  for (std::uint32_t i = 1; i < vertices.count; ++i)
    if (w[i] != w[0])
      return abi::Interpolation::Perspective;
  int exponent = 0;
  const bool isExact = vertices.count == 0 || std::fabs(std::frexp(w[0], &exponent)) == 0.5f;
  return isExact ? abi::Interpolation::Linear : abi::Interpolation::Even;
}

} // namespace arbiter::swrast
