// Checks polygons drawn as lines or points: what is drawn, and from which corner on.
#include <gtest/gtest.h>

#include "swrast/testing/canvas.h"

namespace arbiter::swrast {
namespace {

using testing::Canvas;
using testing::drawAll;
using testing::WindowVertices;

std::uint32_t drawnIn(Canvas &canvas, const Rect &rect) {
  std::uint32_t count = 0;
  for (int y = rect.y; y < rect.y + rect.height; ++y)
    for (int x = rect.x; x < rect.x + rect.width; ++x)
      count += canvas.at(x, y);
  return count;
}

/// Adds a right-angled triangle, counterclockwise, whose width and height are `size`.
void addTriangle(WindowVertices &vertices, double x, double y, double size) {
  vertices.add(x, y);
  vertices.add(x + size, y);
  vertices.add(x, y + size);
}

TEST(Strokes, TheStippleRestartsWithEveryTriangle) {
  Canvas canvas(128, 48);
  canvas.state.front = PolygonMode::Line;
  canvas.state.lineStipple = 0x7FF0;
  canvas.state.lineStippleFactor = 1;
  WindowVertices vertices(canvas);
  addTriangle(vertices, 4.5, 4.5, 37); // sides are no multiple of the stipple pattern
  addTriangle(vertices, 64.5, 4.5, 37);
  drawAll(canvas, Topology::Triangles, vertices);
  EXPECT_GT(drawnIn(canvas, {0, 0, 64, 48}), 40u);
  EXPECT_LT(drawnIn(canvas, {0, 0, 64, 48}), 100u) << "stippled";
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 60; ++x)
      ASSERT_EQ(canvas.at(x, y), canvas.at(x + 60, y)) << x << ", " << y;
}

TEST(Strokes, TheStippleGoesAroundAQuad) {
  // The pattern is eight on, eight off. Each side of 24 alone would have 16 on; around the quad it
  // is half of 96.
  Canvas canvas(32, 32);
  canvas.state.front = PolygonMode::Line;
  canvas.state.lineStipple = 0x00FF;
  canvas.state.lineStippleFactor = 1;
  WindowVertices vertices(canvas);
  vertices.add(4.5, 4.5);
  vertices.add(28.5, 4.5);
  vertices.add(28.5, 28.5);
  vertices.add(4.5, 28.5);
  drawAll(canvas, Topology::Quads, vertices);
  EXPECT_NEAR(drawnIn(canvas, {0, 0, 32, 32}), 48, 4);
}

TEST(Strokes, ACutByAPlaneOfTheApplicationIsASide) {
  for (const PolygonMode mode : {PolygonMode::Line, PolygonMode::Point}) {
    Canvas canvas(32, 32);
    canvas.state.front = mode;
    WindowVertices vertices(canvas);
    addTriangle(vertices, 2.5, 2.5, 26);
    Vertices arrays = vertices.get();
    const float distance[3] = {10.0f, -16.0f, 10.0f}; // clips what is right of x = 12.5
    arrays.clipDistance[0] = distance;
    rasterize(canvas.state, canvas.shading, Topology::Triangles, arrays, nullptr, 0, 3);
    if (mode == PolygonMode::Line)
      EXPECT_GT(drawnIn(canvas, {12, 4, 1, 12}), 10u) << "along the cut";
    else
      EXPECT_EQ(drawnIn(canvas, {0, 0, 32, 32}), 4u) << "its two ends are corners like the others";
    EXPECT_EQ(drawnIn(canvas, {14, 0, 18, 32}), 0u);
  }
}

TEST(Strokes, TheViewVolumesSidesAreNone) {
  Canvas canvas(32, 32);
  canvas.state.front = PolygonMode::Line;
  WindowVertices vertices(canvas);
  vertices.add(-20.5, 8.5);
  vertices.add(16.5, 8.5);
  vertices.add(16.5, 24.5);
  drawAll(canvas, Topology::Triangles, vertices);
  EXPECT_GT(drawnIn(canvas, {16, 9, 1, 14}), 12u);
  EXPECT_EQ(drawnIn(canvas, {0, 10, 1, 4}), 0u) << "cut at the left side of the view";
}

TEST(Strokes, CornersAsPointsTakeTheirVerticesSizes) {
  Canvas canvas(32, 32);
  canvas.state.front = PolygonMode::Point;
  canvas.state.pointSize = 1;
  WindowVertices vertices(canvas);
  addTriangle(vertices, 6.5, 6.5, 16);
  Vertices arrays = vertices.get();
  const float sizes[3] = {3, 5, 1};
  arrays.pointSize = sizes;
  rasterize(canvas.state, canvas.shading, Topology::Triangles, arrays, nullptr, 0, 3);
  EXPECT_EQ(drawnIn(canvas, {0, 0, 12, 12}), 9u);
  EXPECT_EQ(drawnIn(canvas, {16, 0, 16, 12}), 25u);
  EXPECT_EQ(drawnIn(canvas, {0, 16, 12, 16}), 1u);
}

/// Writes the face that the stencil test of a fragment uses.
void writeSide(const abi::FragmentData *data, const abi::Primitive *primitive, const void *items,
               std::uint32_t count) {
  const auto *const spans = static_cast<const abi::Span *>(items);
  for (std::uint32_t i = 0; i < count; ++i)
    for (int x = spans[i].x; x < spans[i].x + spans[i].count; ++x)
      *reinterpret_cast<std::uint32_t *>(
          data->targets[0].base + std::ptrdiff_t(spans[i].y) * data->targets[0].rowStride +
          std::ptrdiff_t(x) * 4) = primitive->backFacing != 0 ? 2 : 1;
}

TEST(Strokes, OutlinesOfBackFacesAreBackFaces) {
  // OpenGL 2.0, section 4.1.5: a polygon stays a polygon when it is drawn as points or lines.
  for (const PolygonMode mode : {PolygonMode::Line, PolygonMode::Point}) {
    for (const bool clockwise : {false, true}) {
      Canvas canvas(32, 32);
      canvas.shading.row = writeSide;
      canvas.state.front = canvas.state.back = mode;
      canvas.state.frontIsClockwise = clockwise;
      WindowVertices vertices(canvas);
      addTriangle(vertices, 4.5, 4.5, 20);
      drawAll(canvas, Topology::Triangles, vertices);
      std::uint32_t seen = 0;
      for (const std::uint32_t value : canvas.counts)
        seen |= value;
      EXPECT_EQ(seen, clockwise ? 2u : 1u);
    }
  }
}

} // namespace
} // namespace arbiter::swrast
