#pragma once
#include <algorithm>
#include <vector>

#include "swrast/setup/clip.h"
#include "swrast/setup/draw.h"
#include "swrast/setup/shape.h"

/// Converts lines, points, and polygons drawn as such, to shapes.
namespace arbiter::swrast {

/// An end of a line, or a point.
struct StrokeEnd {
  WindowVertex window;
  std::uint8_t place; ///< place in the Cuts of its `Stroke`
};
/// The vertices from which a line or a point takes its inputs.
struct Stroke {
  std::uint32_t vertex[3] = {};
  std::uint32_t provoking = 0;
  bool backFacing = false;
  const Cuts *cuts = nullptr; ///< never null

  /// Returns a Triangle of its ends or corners, from which planes are computed.
  template <typename... Ends> [[nodiscard]] Triangle primitive(const Ends &...ends) const {
    Triangle result;
    std::copy(vertex, vertex + 3, result.vertex);
    result.provoking = provoking;
    result.backFacing = backFacing;
    result.cuts = cuts;
    int k = 0;
    ((result.corner[k] = ends.window, result.place[k++] = ends.place), ...);
    return result;
  }
};

/// Makes the shape of a line without stipple. Returns false if it covers nothing.
[[nodiscard]] bool shapeOfLine(const Draw &draw, const Stroke &stroke, const StrokeEnd &from,
                               const StrokeEnd &to, Shape &shape);
/// The part of a smooth line that is one shape: all of it, or, if its ends differ in w or depth,
/// one of two triangles.
enum class SmoothPart : std::uint8_t { Whole, First, Second };
/// Makes the shape of a smooth line, or of a part of it (abi::Coverage::Line). Returns false if it
/// covers nothing.
[[nodiscard]] bool shapeOfSmoothLine(const Draw &draw, const Stroke &stroke, const StrokeEnd &from,
                                     const StrokeEnd &to, SmoothPart part, Shape &shape);
/// Makes the shape of a point of `size` pixels. Returns false if it covers nothing.
[[nodiscard]] bool shapeOfPoint(const Draw &draw, const Stroke &stroke, const StrokeEnd &at,
                                float size, Shape &shape);
/// Makes the shape of a smooth point (abi::Coverage::Disc). Returns false if it covers nothing.
[[nodiscard]] bool shapeOfSmoothPoint(const Draw &draw, const Stroke &stroke, const StrokeEnd &at,
                                      float size, Shape &shape);

/// Rasterizes lines, points and unfilled polygons in order. Shapes are collected, and shaded when
/// there are many.
class Strokes {
public:
  /// Receives shapes, several at a time.
  struct Sink {
    void (*take)(void *user, const Draw &draw, const Shape *shapes, std::size_t count);
    void *user;
  };
  /// Shades the shapes of a draw.
  void rasterize(const Draw &draw, DrawStatistics &statistics);
  /// Passes the shapes of a draw to the sink.
  void gather(const Draw &draw, const Sink &sink);

private:
  void addLines(const Draw &draw);
  void addPoints(const Draw &draw);
  void addPolygons(const Draw &draw);
  void addTriangle(const Draw &draw, std::uint32_t number);
  void addOutline(const Draw &draw, const ClippedPolygon &polygon, Stroke stroke,
                  std::uint32_t sides, bool clipped);
  void addLine(const Draw &draw, const Stroke &stroke, const StrokeEnd &from, const StrokeEnd &to);
  void addSmoothLine(const Draw &draw, const Stroke &stroke, const StrokeEnd &from,
                     const StrokeEnd &to);
  void addPoint(const Draw &draw, const Stroke &stroke, const StrokeEnd &at, float size);
  /// Returns a slot for the next shape. Each shape sets all fields that are read, so slots are
  /// reused without clearing.
  [[nodiscard]] Shape &nextShape();
  void keepShape(const Draw &draw);
  void handOn(const Draw &draw);

  std::vector<Shape> m_shapes;
  std::size_t m_count = 0; ///< number of shapes in m_shapes that wait
  Sink m_sink = {};
  std::uint32_t m_stipple = 0; ///< current step of the line stipple
};

} // namespace arbiter::swrast
