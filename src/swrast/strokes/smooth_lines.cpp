#include <algorithm>
#include <cmath>

#include "swrast/strokes/strokes.h"

/// Draws smooth lines as rectangles around the line (OpenGL 2.1, 3.4.2, figure 3.4). The rectangle
/// is half a pixel larger on each side, and coverage falls to zero across its border. The
/// specification leaves the formula of coverage open. The formula here is llvmpipe's, so that
/// frames of both look alike: coverage is interpolated with perspective over two triangles.
namespace arbiter::swrast {
namespace {

/// A line's direction, and half the size of its rectangle. It is computed by the steps of llvmpipe,
/// because depths only match if the corners are equal. A line of zero length points along x.
struct Extent {
  Extent(const WindowVertex &a, const WindowVertex &b, const RasterState &state)
      : length(lengthOf(b.x - a.x, b.y - a.y)),
        // A width of NaN counts as 1, because the comparison is then false.
        halfWidth(0.5f * (state.lineWidth > 1 ? std::min(state.lineWidth, 8192.0f) : 1.0f) + 0.5f),
        halfLength(0.5f * length + 0.5f) {
    if (state.lineEndsAsEdges) { // these hosts divide, others use an angle
      alongX = length > 0 ? (b.x - a.x) / length : 1;
      alongY = length > 0 ? (b.y - a.y) / length : 0;
      return;
    }
    const float angle = std::atan2(b.y - a.y, b.x - a.x);
    alongX = std::cos(angle);
    alongY = std::sin(angle);
  }

  static float lengthOf(float x, float y) { return std::sqrt(x * x + y * y); }

  float length, alongX, alongY; ///< in the host's window coordinates
  float halfWidth, halfLength;
};

/// Returns `end` moved outwards and sideways.
WindowVertex cornerAt(const WindowVertex &end, const Extent &extent, float outwards, float sideways,
                      int upsideDownHeight) {
  WindowVertex corner = end;
  corner.x += outwards * extent.alongX - sideways * extent.alongY;
  corner.y += outwards * extent.alongY + sideways * extent.alongX;
  snapVertex(corner, upsideDownHeight);
  return corner;
}

/// A corner of the rectangle, or of one of its triangles, with its place on the line and the end
/// whose inputs it takes.
struct Corner {
  WindowVertex window;
  float across, along; ///< distance in pixels from the middle of the line
  const StrokeEnd *end;
};

/// Computes all planes of a triangle, including the input for abi::Coverage::Line.
void setPlanes(const Draw &draw, const Stroke &stroke, const Extent &extent,
               const Corner *const corner[3], Shape &shape) {
  // llvmpipe gives the corners of these triangles in this order. Planes must begin at the same
  // corner as the host's, because rounding depends on it.
  constexpr int kOrder[3] = {1, 0, 2};
  Triangle plane = stroke.primitive(*corner[0]->end, *corner[1]->end, *corner[2]->end);
  float scale[3];
  // The input for coverage comes after those of the program.
  const std::uint32_t coverageInput = draw.shading.inputCount - 1;
  const bool isDivided =
      draw.shading.interpolation[coverageInput] == abi::Interpolation::Perspective;
  for (int k = 0; k < 3; ++k) {
    plane.corner[k] = corner[k]->window;
    scale[k] = isDivided ? plane.corner[k].inverseW : 1.0f;
  }
  const HostOrder turn(draw.state,
                       {{plane.corner[kOrder[0]], plane.corner[kOrder[1]], plane.corner[kOrder[2]]},
                        {0, 1, 2},
                        draw.state.provokingIsFirst ? 0u : 2u});
  int order[3]; // corners in the order that llvmpipe computes planes with
  for (int k = 0; k < 3; ++k)
    order[k] = kOrder[turn.corner[k]];
  const PlaneSteps steps(
      draw.state, {&plane.corner[order[0]], &plane.corner[order[1]], &plane.corner[order[2]]});
  // The ends of an unfilled polygon's sides have its offset already.
  if (draw.plan.wantsDepth)
    shape.primitive.z = makeDepthPlane(draw.state, steps, false);
  makePlanes(draw.plan, plane, steps, order, shape.primitive);
  const auto planeOf = [&](float a, float b, float c) {
    const float values[3] = {a * scale[0], b * scale[1], c * scale[2]};
    return steps.plane({values[order[0]], values[order[1]], values[order[2]]});
  };
  // A line shorter than a pixel covers proportionally less.
  const float share = extent.length < 1 ? extent.length / extent.halfLength : 1.0f;
  const float reach = extent.halfLength * share, width = extent.halfWidth;
  abi::Plane *const input = shape.primitive.inputs[coverageInput];
  input[0] = planeOf(corner[0]->across, corner[1]->across, corner[2]->across);
  input[1] = planeOf(corner[0]->along * share, corner[1]->along * share, corner[2]->along * share);
  input[2] = planeOf(width, width, width);
  input[3] = planeOf(reach, reach, reach);
}

} // namespace

bool shapeOfSmoothLine(const Draw &draw, const Stroke &stroke, const StrokeEnd &from,
                       const StrokeEnd &to, SmoothPart part, Shape &shape) {
  const Extent extent(from.window, to.window, draw.state);
  const int height = draw.state.upsideDownHeight;
  const auto cornerOf = [&](const StrokeEnd &end, float outwards, float sideways) {
    return Corner{cornerAt(end.window, extent, outwards, sideways, height), sideways,
                  2 * outwards * extent.halfLength, &end};
  };
  const float half = extent.halfWidth;
  const Corner corner[4] = {cornerOf(from, -0.5f, -half), cornerOf(to, 0.5f, -half),
                            cornerOf(to, 0.5f, half), cornerOf(from, -0.5f, half)};
  const Corner *parts[4] = {&corner[0], &corner[1], &corner[2], &corner[3]};
  const int corners = part == SmoothPart::Whole ? 4 : 3;
  if (part == SmoothPart::Second)
    std::copy(parts + 2, parts + 4, parts + 1);
  WindowVertex place[4];
  std::transform(parts, parts + corners, place, [](const Corner *each) { return each->window; });
  if (!setBounds(draw.state.clip, place, corners, shape) || areaOf(place) == 0)
    return false;
  shape.edgeCount = corners;
  shape.stippled = false; // polygon stipple does not apply to lines
  // The corners are counterclockwise in the host's coordinates, which may run downwards.
  for (int i = 0; i < corners; ++i) {
    const WindowVertex &next = place[(i + 1) % corners];
    shape.edges[i] = height == 0 ? edgeBetween(place[i], next) : edgeBetween(next, place[i]);
  }
  setPlanes(draw, stroke, extent, parts, shape);
  return true;
}

} // namespace arbiter::swrast
