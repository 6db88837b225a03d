#include <algorithm>
#include <cmath>

#include "swrast/strokes/strokes.h"

/// Draws lines as parallelograms. Their width is measured along the minor direction, and their ends
/// are cut so that pixels follow the diamond rule (3.4.1) as hosts implement it.
namespace arbiter::swrast {
namespace {

/// Rounds ties away from zero, as the host does for lines, or to even if
/// RasterState::lineEndsAsEdges is set.
std::int32_t rounded(float value, bool toEven) {
  return std::int32_t(toEven ? std::lrint(value) : std::lround(value));
}
float fraction(float value) { return value - std::floor(value); }

/// One end of a line, along the line's major and minor direction.
struct End {
  float major, minor;         ///< window coordinates
  float fromMajor, fromMinor; ///< distance from the centre of its pixel
  [[nodiscard]] bool inDiamond() const {
    return std::fabs(fromMajor) + std::fabs(fromMinor) < 0.5f;
  }
};

/// True if both point the same way. Zero counts as positive in x and as negative in y.
bool same(float a, float b, bool alongY) {
  return alongY ? (-a >= 0) == (-b >= 0) : (a >= 0) == (b >= 0);
}

/// Computes where a line's ends are cut. It uses the host's window coordinates, because their
/// direction decides ties.
class LineCaps {
public:
  LineCaps(const WindowVertex &start, const WindowVertex &finish, bool yMajor,
           const RasterState &state)
      : m_yMajor(yMajor), m_asEdges(state.lineEndsAsEdges),
        m_upsideDown(state.upsideDownHeight != 0), m_start(endOf(start)), m_finish(endOf(finish)) {
    m_travel = m_finish.major - m_start.major;
    m_rise = m_finish.minor - m_start.minor;
    m_slope = m_rise / m_travel;
    // If the finish lies between two pixels, it belongs to the one that the line comes from.
    if (m_finish.fromMinor == -0.5f && m_rise > 0)
      m_finish.fromMinor = 0.5f;
  }
  /// Returns what to add to an end's major coordinate. If a cut at the end itself would draw the
  /// end's pixel wrongly, the cut moves back to the pixel's side.
  [[nodiscard]] float startOffset() const {
    return startCovers() != drawsStart() ? back(m_start) : 0;
  }
  [[nodiscard]] float finishOffset() const {
    return finishCovers() != drawsFinish() ? back(m_finish) : 0;
  }
  [[nodiscard]] float slope() const { return m_slope; }

private:
  /// True if the centre of an end's pixel lies in the line's direction. Ties follow the fill rule
  /// of edges.
  [[nodiscard]] bool isAhead(float from) const {
    if (from != 0)
      return (from < 0) == (m_travel > 0);
    return (m_travel > 0) != (m_yMajor && m_upsideDown);
  }
  /// True if a cut at the start itself would put the centre of the start's pixel inside.
  [[nodiscard]] bool startCovers() const {
    const float from = m_start.fromMajor;
    if (m_asEdges)
      return isAhead(from);
    if (m_yMajor)
      return m_travel > 0 ? from < 0 : from >= 0;
    return m_travel > 0 ? from <= 0 : from > 0;
  }
  [[nodiscard]] bool finishCovers() const {
    if (m_asEdges)
      return !isAhead(m_finish.fromMajor);
    return m_travel > 0 ? m_finish.fromMajor >= 0 : m_finish.fromMajor <= 0;
  }
  [[nodiscard]] float back(const End &end) const {
    return -end.fromMajor - (m_travel > 0 ? 0.5f : -0.5f);
  }
  [[nodiscard]] End endOf(const WindowVertex &vertex) const {
    const float major = m_yMajor ? vertex.y : vertex.x, minor = m_yMajor ? vertex.x : vertex.y;
    return {major, minor, fraction(major) - 0.5f, fraction(minor) - 0.5f};
  }
  /// Returns where the line crosses the centre line of the pixel's column (or row).
  [[nodiscard]] float crossing(const End &end) const {
    return fraction(end.minor) + end.fromMajor * m_slope;
  }
  [[nodiscard]] bool drawsStart() const {
    if (m_start.inDiamond())
      return true;
    if (same(m_start.fromMajor, m_travel, m_yMajor))
      return false;
    if (!same(m_start.fromMinor, m_rise, !m_yMajor))
      return true;
    const float at = crossing(m_start);
    return at < 1 && at > 0;
  }
  [[nodiscard]] bool drawsFinish() const {
    if (m_finish.inDiamond() || !same(m_finish.fromMajor, m_travel, m_yMajor))
      return false;
    if (same(m_finish.fromMinor, m_rise, !m_yMajor))
      return true;
    const float at = crossing(m_finish);
    return at < 1 && (m_yMajor ? at >= 0 : at > 0);
  }

  bool m_yMajor, m_asEdges, m_upsideDown;
  End m_start, m_finish;
  float m_travel, m_rise, m_slope;
};

} // namespace

bool shapeOfLine(const Draw &draw, const Stroke &stroke, const StrokeEnd &from, const StrokeEnd &to,
                 Shape &shape) {
  const WindowVertex &a = from.window, &b = to.window;
  if (a.x == b.x && a.y == b.y)
    return false;
  const bool yMajor = std::fabs(b.x - a.x) < std::fabs(b.y - a.y);
  const LineCaps caps(a, b, yMajor, draw.state);
  const float wanted = draw.state.lineWidth;
  const float width = wanted > 1 ? std::min(wanted, 8192.0f) : 1.0f; // NaN becomes 1
  const bool toEven = draw.state.lineEndsAsEdges;
  const int half = rounded(width, toEven) * kSubpixels / 2;
  const auto snap = [toEven](float value) {
    return rounded((value - 0.5f) * float(kSubpixels), toEven);
  };
  WindowVertex corner[4]{}; // two of the start, two of the finish
  const auto place = [&](const WindowVertex &end, float offset, WindowVertex &low,
                         WindowVertex &high) {
    const float shift = offset * caps.slope();
    low.fixedX = high.fixedX = snap(end.x + (yMajor ? shift : offset));
    low.fixedY = high.fixedY = snap(end.y + (yMajor ? offset : shift));
    if (draw.state.upsideDownHeight != 0)
      low.fixedY = high.fixedY = (draw.state.upsideDownHeight - 1) * kSubpixels - low.fixedY;
    (yMajor ? low.fixedX : low.fixedY) -= half;
    (yMajor ? high.fixedX : high.fixedY) += half;
  };
  place(a, caps.startOffset(), corner[0], corner[3]);
  place(b, caps.finishOffset(), corner[1], corner[2]);
  if (!setBounds(draw.state.clip, corner, 4, shape))
    return false;
  // If the cut moved back beyond the other end, nothing is left.
  const std::int64_t area = areaOf(corner);
  const bool upwards = (b.y > a.y) == (draw.state.upsideDownHeight == 0);
  if (area == 0 || (area > 0) != (yMajor ? !upwards : b.x > a.x))
    return false;
  shape.edgeCount = 4;
  for (int i = 0; i < 4; ++i) {
    const WindowVertex &next = corner[(i + 1) & 3];
    shape.edges[i] = area > 0 ? edgeBetween(corner[i], next) : edgeBetween(next, corner[i]);
  }
  shape.stippled = false;
  makeLinePlanes(draw.state, draw.plan, stroke.primitive(from, to), shape.primitive);
  return true;
}

} // namespace arbiter::swrast
