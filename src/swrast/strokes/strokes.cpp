#include "swrast/strokes/strokes.h"

#include <algorithm>
#include <cmath>

#include "swrast/cover/direct.h"
#include "swrast/setup/triangles.h"

namespace arbiter::swrast {
namespace {

constexpr std::size_t kMaxShapes = 512;

StrokeEnd endOf(const ClipVertex &vertex) { return {vertex.window, vertex.place}; }

constexpr Cuts kUncut = {};

/// Returns the point at fraction `t` of the way, as hosts cut a stippled line.
StrokeEnd between(const StrokeEnd &a, const StrokeEnd &b, float t, Cuts &cuts) {
  const auto mix = [t](float from, float to) { return from + t * (to - from); };
  StrokeEnd end = a;
  end.window.x = mix(a.window.x, b.window.x);
  end.window.y = mix(a.window.y, b.window.y);
  end.window.z = mix(a.window.z, b.window.z);
  end.window.inverseW = mix(a.window.inverseW, b.window.inverseW);
  // Inputs are linear in clip space, not in the window.
  double share = t;
  if (a.window.inverseW != b.window.inverseW)
    share = double(t) * b.window.inverseW / end.window.inverseW;
  end.place = cuts.add(a.place, b.place, float(share));
  return end;
}

/// Returns the winding, positive if counterclockwise. It uses positions that are not snapped,
/// because a polygon too thin to fill still has sides and a winding.
int windingOf(const Draw &draw, const ClippedPolygon &polygon) {
  double area = 0;
  const WindowVertex &a = polygon.vertex[0].window;
  for (int i = 2; i < polygon.count; ++i) {
    const WindowVertex &b = polygon.vertex[std::size_t(i - 1)].window;
    const WindowVertex &c = polygon.vertex[std::size_t(i)].window;
    area += (double(b.x) - a.x) * (double(c.y) - a.y) - (double(c.x) - a.x) * (double(b.y) - a.y);
  }
  if (draw.state.upsideDownHeight != 0)
    area = -area;
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// Rotates a triangle's corners into the order of hosts: the provoking one is the first or the
/// last.
TriangleCorners asHostsWalk(const TriangleCorners &corners, bool provokingIsFirst) {
  const std::uint32_t wanted = provokingIsFirst ? 0 : 2;
  TriangleCorners turned = corners;
  for (int i = 0; i < 2 && turned.corner[wanted] != corners.provoking; ++i) {
    std::rotate(turned.corner, turned.corner + 1, turned.corner + 3);
    turned.sides = turned.sides >> 1 | (turned.sides & 1u) << 2;
  }
  return turned;
}

/// Returns the side that hosts draw as number `i`. They begin with the last side of a triangle, but
/// with the first of a clipped one, where the last two sides may be swapped.
int sideInTurn(int i, int count, bool clipped, bool provokingIsFirst) {
  if (!clipped || (provokingIsFirst && count == 3))
    return (count - 1 + i) % count;
  if (provokingIsFirst && i >= count - 2)
    return i == count - 2 ? count - 1 : count - 2;
  return i;
}

/// Returns the corner that hosts draw as point number `i`. A clipped triangle is a fan to them. If
/// the provoking corner is the last, each piece of the fan ends with its centre, corner 0.
int pointInTurn(int i, bool clipped, bool provokingIsFirst) {
  return clipped && !provokingIsFirst && i < 2 ? 1 - i : i;
}

/// Returns the polygon offset for the ends of side `side`. Hosts split a clipped triangle into a
/// fan whose pieces have slopes of their own. The centre is each piece's first or last corner.
float offsetAt(const RasterState &state, const ClippedPolygon &polygon, int side, bool clipped) {
  const auto next = std::size_t(std::clamp(side + 1, 2, polygon.count - 1));
  const WindowVertex &centre = polygon.vertex[0].window;
  const WindowVertex &from = polygon.vertex[next - 1].window, &to = polygon.vertex[next].window;
  if (clipped && !state.provokingIsFirst)
    return depthOffset(state, {from, to, centre});
  return depthOffset(state, {centre, from, to});
}

/// Returns the number of stipple steps: pixels along the major direction, or, for a smooth line,
/// along the line itself (OpenGL 2.1, 3.4.2).
float lengthOf(const RasterState &state, const WindowVertex &from, const WindowVertex &to) {
  const float x = std::fabs(to.x - from.x), y = std::fabs(to.y - from.y);
  return state.coverage == abi::Coverage::Line ? std::hypot(x, y) : std::max(x, y);
}

/// Returns the point size at a vertex, or at a point that clipping created.
float pointSizeAt(const Draw &draw, const Stroke &stroke, const StrokeEnd &at) {
  const float *const sizes = draw.vertices.pointSize;
  if (!sizes)
    return draw.state.pointSize;
  float value[Cuts::kVertices + Cuts::kMax];
  for (int i = 0; i < Cuts::kVertices; ++i)
    value[i] = sizes[stroke.vertex[i]];
  stroke.cuts->follow(value);
  return value[at.place];
}

} // namespace

void Strokes::handOn(const Draw &draw) {
  if (m_count != 0)
    m_sink.take(m_sink.user, draw, m_shapes.data(), m_count);
  m_count = 0;
}

Shape &Strokes::nextShape() {
  if (m_count == m_shapes.size()) [[unlikely]]
    m_shapes.emplace_back();
  return m_shapes[m_count];
}

void Strokes::keepShape(const Draw &draw) {
  if (++m_count >= kMaxShapes)
    handOn(draw);
}

void Strokes::rasterize(const Draw &draw, DrawStatistics &statistics) {
  const auto shade = [](void *user, const Draw &of, const Shape *shapes, std::size_t count) {
    auto &done = *static_cast<DrawStatistics *>(user);
    done.primitives += count;
    done.pixels += shadeInBands(of.state, of.shading, shapes, count);
  };
  gather(draw, {shade, &statistics});
}

void Strokes::gather(const Draw &draw, const Sink &sink) {
  m_sink = sink;
  m_count = 0;
  m_stipple = 0;
  if (isPolygonal(draw.topology))
    addPolygons(draw);
  else if (draw.topology == Topology::Points)
    addPoints(draw);
  else
    addLines(draw);
  handOn(draw);
}

void Strokes::addPoint(const Draw &draw, const Stroke &stroke, const StrokeEnd &at, float size) {
  if (draw.state.coverage == abi::Coverage::Disc
          ? shapeOfSmoothPoint(draw, stroke, at, size, nextShape())
          : shapeOfPoint(draw, stroke, at, size, nextShape()))
    keepShape(draw);
}

void Strokes::addSmoothLine(const Draw &draw, const Stroke &stroke, const StrokeEnd &from,
                            const StrokeEnd &to) {
  const auto add = [&](SmoothPart part) {
    if (shapeOfSmoothLine(draw, stroke, from, to, part, nextShape()))
      keepShape(draw);
  };
  const bool isLevel = !draw.plan.wantsDepth || from.window.z == to.window.z;
  if (isLevel && from.window.inverseW == to.window.inverseW)
    return add(SmoothPart::Whole);
  add(SmoothPart::First);
  add(SmoothPart::Second);
}

void Strokes::addLine(const Draw &draw, const Stroke &stroke, const StrokeEnd &from,
                      const StrokeEnd &to) {
  const auto add = [&](const Stroke &own, const StrokeEnd &a, const StrokeEnd &b) {
    if (draw.state.coverage == abi::Coverage::Line)
      addSmoothLine(draw, own, a, b);
    else if (shapeOfLine(draw, own, a, b, nextShape()))
      keepShape(draw);
  };
  if (draw.state.lineStippleFactor <= 0) {
    add(stroke, from, to);
    return;
  }
  const float length = lengthOf(draw.state, from.window, to.window);
  const auto factor = std::uint32_t(draw.state.lineStippleFactor);
  const int steps = int(std::ceil(std::min(length, 1e6f)));
  int start = -1;
  for (int i = 0; i <= steps; ++i) {
    const std::uint32_t bit = (m_stipple + std::uint32_t(i)) / factor & 15u;
    const bool on = i < steps && ((draw.state.lineStipple >> bit) & 1u) != 0;
    if (on && start < 0)
      start = i;
    if (on || start < 0)
      continue;
    Cuts cuts = *stroke.cuts;
    Stroke dash = stroke;
    dash.cuts = &cuts;
    const StrokeEnd a = start == 0 ? from : between(from, to, float(start) / length, cuts);
    add(dash, a, i == steps ? to : between(from, to, float(i) / length, cuts));
    start = -1;
  }
  m_stipple += std::uint32_t(steps);
}

void Strokes::addLines(const Draw &draw) {
  const std::uint32_t lines = lineCount(draw.topology, draw.count);
  for (std::uint32_t i = 0; i < lines; ++i) {
    const LineEnds ends = lineAt(draw.topology, draw.count, i, draw.state.provokingIsFirst);
    if (ends.restartsStipple)
      m_stipple = 0;
    const std::uint32_t index[2] = {draw.vertexAt(ends.end[0]), draw.vertexAt(ends.end[1])};
    if (index[0] >= draw.vertices.count || index[1] >= draw.vertices.count)
      continue;
    const WindowVertex &a = draw.window[index[0]], &b = draw.window[index[1]];
    if ((a.outcode & b.outcode & kOutsideMask) || ((a.outcode | b.outcode) & kOutNan))
      continue;
    // Zero length covers no pixel and takes no stipple step. A smooth line still covers half a
    // pixel around it.
    if (a.x == b.x && a.y == b.y && !((a.outcode | b.outcode) & kClipMask) &&
        (draw.state.coverage != abi::Coverage::Line || draw.state.lineStippleFactor > 0))
      continue;
    Stroke stroke = {{index[0], index[1], index[1]}, draw.vertexAt(ends.provoking), false, &kUncut};
    if (!((a.outcode | b.outcode) & kClipMask)) {
      addLine(draw, stroke, {a, 0}, {b, 1});
      continue;
    }
    const WindowVertex corner[2] = {a, b};
    ClipVertex end[2];
    Cuts cuts;
    stroke.cuts = &cuts;
    if (clipLine(draw.viewport, draw.vertices, index, corner, end, cuts))
      addLine(draw, stroke, endOf(end[0]), endOf(end[1]));
  }
}

void Strokes::addPoints(const Draw &draw) {
  for (std::uint32_t i = 0; i < draw.count; ++i) {
    const std::uint32_t index = draw.vertexAt(i);
    if (index >= draw.vertices.count)
      continue;
    if (draw.window[index].outcode != 0)
      continue;
    const Stroke stroke = {{index, index, index}, index, false, &kUncut};
    const StrokeEnd at = {draw.window[index], 0};
    addPoint(draw, stroke, at, pointSizeAt(draw, stroke, at));
  }
}

void Strokes::addOutline(const Draw &draw, const ClippedPolygon &polygon, Stroke stroke,
                         std::uint32_t sides, bool clipped) {
  const bool lines = draw.modeOf(stroke.backFacing) == PolygonMode::Line;
  const bool offset = lines ? draw.state.offsetLine : draw.state.offsetPoint;
  const auto endAt = [&](int corner, int side) {
    StrokeEnd end = endOf(polygon.vertex[std::size_t(corner)]);
    if (offset)
      end.window.z += offsetAt(draw.state, polygon, side, clipped);
    return end;
  };
  const auto isSide = [&](int corner) {
    const int side = polygon.vertex[std::size_t(corner)].side;
    return side == kOnUserPlane || (side < kOnPlane && ((sides >> side) & 1u) != 0);
  };
  for (int i = 0; i < polygon.count; ++i) {
    const int at = sideInTurn(i, polygon.count, clipped, draw.state.provokingIsFirst);
    if (lines && isSide(at))
      addLine(draw, stroke, endAt(at, at), endAt(at + 1 == polygon.count ? 0 : at + 1, at));
    if (const int corner = pointInTurn(i, clipped, draw.state.provokingIsFirst);
        !lines && isSide(corner)) {
      const StrokeEnd end = endAt(corner, corner);
      addPoint(draw, stroke, end, pointSizeAt(draw, stroke, end));
    }
  }
}

void Strokes::addTriangle(const Draw &draw, std::uint32_t number) {
  const RasterState &state = draw.state;
  const TriangleCorners corners = asHostsWalk(
      triangleAt(draw.topology, draw.count, number, provokesFirst(state, draw.topology), true),
      state.provokingIsFirst);
  Triangle triangle;
  std::uint32_t any = 0;
  if (!fetchTriangle(draw, corners, triangle, any))
    return;
  ClippedPolygon polygon;
  if (any & kClipMask) {
    clipTriangle(draw.viewport, draw.vertices, triangle.vertex, triangle.corner, polygon);
    m_stipple = 0; // a clipped polygon does not continue the stipple
  } else {
    polygon.count = 3;
    for (int i = 0; i < 3; ++i) {
      ClipVertex &vertex = polygon.vertex[std::size_t(i)];
      vertex.window = triangle.corner[i];
      vertex.place = std::uint8_t(i);
      vertex.side = i;
    }
  }
  if (polygon.count < 3)
    return;
  const int facing = windingOf(draw, polygon);
  // Without a winding, hosts assume the one that is negative in their own coordinates.
  const int unwound = state.upsideDownHeight != 0 ? -1 : 1;
  triangle.backFacing = isBackFacing(state, facing != 0 ? facing : unwound);
  if (isCulled(state, triangle.backFacing) || (facing == 0 && (state.cullFront || state.cullBack)))
    return;
  const PolygonMode mode = draw.modeOf(triangle.backFacing);
  if (mode == PolygonMode::Fill) {
    Shape shape;
    const auto take = [&](const Triangle &part, Shape &filled) {
      filled.stippled = state.polygonStipple != nullptr;
      makePlanes(state, draw.plan, part, state.offsetFill, filled.primitive);
      nextShape() = filled;
      keepShape(draw);
    };
    if (any & kClipMask)
      clipAndTake(draw, triangle, take);
    else if (const std::int64_t area = areaOf(triangle.corner);
             area != 0 && shapeOf(state.clip, triangle.corner, area, shape))
      take(triangle, shape);
    return;
  }
  std::uint32_t sides = corners.sides;
  if (draw.vertices.edgeFlags)
    for (int i = 0; i < 3; ++i)
      if (!draw.vertices.edgeFlags[triangle.vertex[i]])
        sides &= ~(1u << i);
  addOutline(draw, polygon,
             {{triangle.vertex[0], triangle.vertex[1], triangle.vertex[2]},
              triangle.provoking,
              triangle.backFacing,
              &polygon.cuts},
             sides, (any & kClipMask) != 0);
}

void Strokes::addPolygons(const Draw &draw) {
  const std::uint32_t triangles = triangleCount(draw.topology, draw.count);
  const bool quads = draw.topology == Topology::Quads || draw.topology == Topology::QuadStrip;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    // The stipple continues around a whole polygon or quad.
    if (quads ? i % 2 == 0 : draw.topology != Topology::Polygon)
      m_stipple = 0;
    addTriangle(draw, i);
  }
}

} // namespace arbiter::swrast
