#include "raster.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gallery {

namespace {

constexpr double kSubpixels = 256;

using Polygon = std::vector<Vertex>;
/// A clip plane; its value is not negative on the side that stays.
using Plane = double (*)(const glm::dvec4 &);

double aboveZeroW(const glm::dvec4 &at) { return at.w - 1e-6; }
double behindNear(const glm::dvec4 &at) { return at.w + at.z; }
double beforeFar(const glm::dvec4 &at) { return at.w - at.z; }

Vertex between(const Vertex &a, const Vertex &b, double t) {
  Vertex vertex;
  vertex.clip = a.clip + (b.clip - a.clip) * t;
  for (std::size_t i = 0; i < kVaryings; ++i)
    vertex.varyings[i] = a.varyings[i] + (b.varyings[i] - a.varyings[i]) * float(t);
  return vertex;
}

Polygon clipped(const Polygon &polygon, Plane plane) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double begin = plane(from.clip), end = plane(to.clip);
    if (begin >= 0)
      result.push_back(from);
    if ((begin >= 0) != (end >= 0))
      result.push_back(between(from, to, begin / (begin - end)));
  }
  return result;
}

struct Corner {
  std::int64_t x, y; ///< subpixels
  double z, inverseW;
  const Vertex *vertex;
};

Corner cornerOf(const Vertex &vertex, int width, int height) {
  const double inverseW = 1 / vertex.clip.w;
  const auto snap = [](double pixels) { return std::int64_t(std::llround(pixels * kSubpixels)); };
  return {snap((vertex.clip.x * inverseW * 0.5 + 0.5) * width),
          snap((vertex.clip.y * inverseW * 0.5 + 0.5) * height),
          vertex.clip.z * inverseW * 0.5 + 0.5, inverseW, &vertex};
}

/// Returns twice the area of (a, b, p): positive if p is to the left of the edge.
double edge(const Corner &a, const Corner &b, std::int64_t x, std::int64_t y) {
  return double(b.x - a.x) * double(y - a.y) - double(b.y - a.y) * double(x - a.x);
}

/// True if a pixel center on the edge is inside: this holds for one of the two triangles that share
/// it.
bool ownsBorder(const Corner &a, const Corner &b) { return b.y < a.y || (b.y == a.y && b.x < a.x); }

class Triangle {
public:
  Triangle(std::array<Corner, 3> corners, bool front, const std::array<bool, kVaryings> &used)
      : m_corners(corners), m_front(front), m_used(used),
        m_area(edge(corners[0], corners[1], corners[2].x, corners[2].y)) {}

  void draw(int width, int height, const Shade &shade) const {
    const auto [minX, maxX] = std::minmax({m_corners[0].x, m_corners[1].x, m_corners[2].x});
    const auto [minY, maxY] = std::minmax({m_corners[0].y, m_corners[1].y, m_corners[2].y});
    const auto pixel = [](std::int64_t at, int most) {
      return int(std::clamp<std::int64_t>(at / std::int64_t(kSubpixels), 0, most));
    };
    for (int y = pixel(minY, height - 1); y <= pixel(maxY, height - 1); ++y)
      for (int x = pixel(minX, width - 1); x <= pixel(maxX, width - 1); ++x)
        drawPixel(x, y, shade);
  }

private:
  void drawPixel(int x, int y, const Shade &shade) const {
    const auto px = std::int64_t(x * kSubpixels + kSubpixels / 2);
    const auto py = std::int64_t(y * kSubpixels + kSubpixels / 2);
    std::array<double, 3> weights = {};
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner &from = m_corners[(i + 1) % 3], &to = m_corners[(i + 2) % 3];
      const double side = edge(from, to, px, py);
      if (side < 0 || (side == 0 && !ownsBorder(from, to)))
        return;
      weights[i] = side / m_area;
    }
    Fragment fragment;
    fragment.x = x;
    fragment.y = y;
    fragment.front = m_front;
    fragment.depth = fragment.inverseW = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      fragment.depth += weights[i] * m_corners[i].z;
      fragment.inverseW += weights[i] *= m_corners[i].inverseW;
    }
    for (std::size_t k = 0; k < kVaryings; ++k)
      if (m_used[k])
        for (std::size_t i = 0; i < 3; ++i)
          fragment.varyings[k] +=
              m_corners[i].vertex->varyings[k] * float(weights[i] / fragment.inverseW);
    shade(fragment);
  }

  std::array<Corner, 3> m_corners;
  bool m_front;
  const std::array<bool, kVaryings> &m_used;
  double m_area;
};

} // namespace

void rasterize(const Vertex &a, const Vertex &b, const Vertex &c, int width, int height,
               const std::array<bool, kVaryings> &used, const Shade &shade) {
  Polygon polygon = {a, b, c};
  for (const Plane plane : {aboveZeroW, behindNear, beforeFar})
    polygon = clipped(polygon, plane);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    std::array<Corner, 3> corners = {cornerOf(polygon[0], width, height),
                                     cornerOf(polygon[i], width, height),
                                     cornerOf(polygon[i + 1], width, height)};
    const double area = edge(corners[0], corners[1], corners[2].x, corners[2].y);
    if (area == 0)
      continue;
    if (area < 0)
      std::swap(corners[1], corners[2]);
    Triangle(corners, area > 0, used).draw(width, height, shade);
  }
}

} // namespace gallery
