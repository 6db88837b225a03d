#pragma once
#include <algorithm>
#include <vector>

#include "swrast/setup/clip.h"
#include "swrast/setup/draw.h"
#include "swrast/setup/shape.h"

/// Lines, points, and polygons drawn as such, to shapes.
namespace arbiter::swrast {

/// An end of a line, or a point.
struct StrokeEnd {
  WindowVertex window;
  std::uint8_t place; ///< of the cuts that `Stroke` has
};
/// Whose inputs a line or a point takes.
struct Stroke {
  std::uint32_t vertex[3] = {};
  std::uint32_t provoking = 0;
  bool backFacing = false;
  const Cuts *cuts = nullptr; ///< never null

  /// A primitive of its ends, or corners, as planes are made of it.
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

/// One line without stipple. False if it covers nothing.
[[nodiscard]] bool shapeOfLine(const Draw &draw, const Stroke &stroke, const StrokeEnd &from,
                               const StrokeEnd &to, Shape &shape);
/// What of a smooth line is one shape: all, or where its ends differ in w or depth either triangle.
enum class SmoothPart : std::uint8_t { Whole, First, Second };
/// The same of a smooth line, or a part of it (abi::Coverage::Line).
[[nodiscard]] bool shapeOfSmoothLine(const Draw &draw, const Stroke &stroke, const StrokeEnd &from,
                                     const StrokeEnd &to, SmoothPart part, Shape &shape);
/// A point of `size` pixels.
[[nodiscard]] bool shapeOfPoint(const Draw &draw, const Stroke &stroke, const StrokeEnd &at,
                                float size, Shape &shape);
/// The same of a smooth point (abi::Coverage::Disc).
[[nodiscard]] bool shapeOfSmoothPoint(const Draw &draw, const Stroke &stroke, const StrokeEnd &at,
                                      float size, Shape &shape);

/// Lines, points and polygons that are not filled, in order; shapes are shaded as they get many.
class Strokes {
public:
  /// Where shapes go, some at a time.
  struct Sink {
    void (*take)(void *user, const Draw &draw, const Shape *shapes, std::size_t count);
    void *user;
  };
  /// Shades them.
  void rasterize(const Draw &draw, DrawStatistics &statistics);
  /// Hands them to the sink.
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
  /// Where the next shape is made. What is read of a shape is written of each, so that one that
  /// was shaded is used again as it is.
  [[nodiscard]] Shape &nextShape();
  void keepShape(const Draw &draw);
  void handOn(const Draw &draw);

  std::vector<Shape> m_shapes;
  std::size_t m_count = 0; ///< of m_shapes that wait
  Sink m_sink = {};
  std::uint32_t m_stipple = 0; ///< steps into the line stipple
};

} // namespace arbiter::swrast
